package org.hificamsim.core.obstacle;

import java.math.BigDecimal;

/**
 * Exact tests of closed discs against points and segments. Squared distances are compared with the
 * squared radius: in doubles if they differ by more than the rounding error, else in decimals of
 * unlimited length, which allocate.
 */
final class Discs {
  /**
   * A bound on the relative error of all sums and products here: up to 5 roundings of 2^-53 each.
   */
  private static final double ROUNDING = 1e-15;

  /** The least reliable square: smaller ones may have lost digits to underflow. */
  private static final double SMALLEST_SQUARE = 1e-200;

  private Discs() {}

  /** Whether a point is inside the disc or on its border. */
  static boolean contains(double x, double y, double radius, double pointX, double pointY) {
    double dx = pointX - x;
    double dy = pointY - y;
    double distance = dx * dx + dy * dy;
    double square = radius * radius;
    double bound = ROUNDING * (distance + square) + Double.MIN_NORMAL;
    if (distance - square > bound) {
      return false;
    }
    return square - distance > bound || containsExactly(x, y, radius, pointX, pointY);
  }

  /** Whether the closed segment from a to b has a point in common with the disc. */
  static boolean touch(
      double x, double y, double radius, double ax, double ay, double bx, double by) {
    double dx = bx - ax;
    double dy = by - ay;
    if (dx == 0 && dy == 0) {
      return contains(x, y, radius, ax, ay);
    }
    int pastA = sign((x - ax) * dx, (y - ay) * dy);
    int beforeB = sign((bx - x) * dx, (by - y) * dy);
    if (pastA < 0) {
      return contains(x, y, radius, ax, ay);
    }
    if (beforeB < 0) {
      return contains(x, y, radius, bx, by);
    }
    int line = pastA > 0 && beforeB > 0 ? lineWithinRadius(x - ax, y - ay, radius, dx, dy) : 0;
    return line > 0 || (line == 0 && touchExactly(x, y, radius, ax, ay, bx, by));
  }

  /** The sign of a sum of two products of differences; 0 if it may be a rounding error. */
  private static int sign(double a, double b) {
    double bound = ROUNDING * (Math.abs(a) + Math.abs(b)) + Double.MIN_NORMAL;
    return a + b > bound ? 1 : a + b < -bound ? -1 : 0;
  }

  /** Returns 1 if the line along d comes within the radius of a point, -1 if not, 0 if unsure. */
  private static int lineWithinRadius(double fx, double fy, double radius, double dx, double dy) {
    double square = dx * dx + dy * dy;
    double reach = radius * Math.sqrt(square);
    double offset = Math.abs(dx * fy - dy * fx);
    double bound = ROUNDING * (Math.abs(dx * fy) + Math.abs(dy * fx) + reach) + Double.MIN_NORMAL;
    boolean certain = square > SMALLEST_SQUARE && Math.abs(reach - offset) > bound;
    return !certain ? 0 : reach > offset ? 1 : -1;
  }

  private static boolean containsExactly(
      double x, double y, double radius, double pointX, double pointY) {
    BigDecimal square =
        square(Orientation.difference(pointX, x), Orientation.difference(pointY, y));
    return square.compareTo(new BigDecimal(radius).pow(2)) <= 0;
  }

  private static boolean touchExactly(
      double x, double y, double radius, double ax, double ay, double bx, double by) {
    if (containsExactly(x, y, radius, ax, ay) || containsExactly(x, y, radius, bx, by)) {
      return true;
    }
    BigDecimal dx = Orientation.difference(bx, ax);
    BigDecimal dy = Orientation.difference(by, ay);
    BigDecimal fx = Orientation.difference(x, ax);
    BigDecimal fy = Orientation.difference(y, ay);
    BigDecimal along = fx.multiply(dx).add(fy.multiply(dy));
    BigDecimal length = square(dx, dy);
    BigDecimal offset = fx.multiply(dy).subtract(fy.multiply(dx));
    return along.signum() > 0
        && along.compareTo(length) < 0
        && offset.pow(2).compareTo(new BigDecimal(radius).pow(2).multiply(length)) <= 0;
  }

  private static BigDecimal square(BigDecimal x, BigDecimal y) {
    return x.pow(2).add(y.pow(2));
  }
}
