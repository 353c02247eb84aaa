package org.hificamsim.core.obstacle;

import java.math.BigDecimal;

/**
 * What a closed disc touches, exactly: squared distances are compared with the squared radius, in
 * doubles where they differ by more than rounding may add, in decimals of any length (which
 * allocate) where they do not.
 */
final class Discs {
  /** More than the relative error of any sum or product below: up to 5 roundings of 2^-53 each. */
  private static final double ROUNDING = 1e-15;

  /** Squares below may have lost digits below a double's range. */
  private static final double SMALLEST_SQUARE = 1e-200;

  private Discs() {}

  /** Whether a point is inside or on the border. */
  static boolean contains(double x, double y, double radius, double atX, double atY) {
    double dx = atX - x;
    double dy = atY - y;
    double distance = dx * dx + dy * dy;
    double square = radius * radius;
    double bound = ROUNDING * (distance + square) + Double.MIN_NORMAL;
    if (distance - square > bound) {
      return false;
    }
    return square - distance > bound || containsExactly(x, y, radius, atX, atY);
  }

  /** Whether the closed segment from a to b has a point of the disc. */
  static boolean touch(
      double x, double y, double radius, double ax, double ay, double bx, double by) {
    double dx = bx - ax;
    double dy = by - ay;
    int pastA = sign((x - ax) * dx, (y - ay) * dy);
    int beforeB = sign((bx - x) * dx, (by - y) * dy);
    if (pastA < 0) {
      return contains(x, y, radius, ax, ay);
    }
    if (beforeB < 0) {
      return contains(x, y, radius, bx, by);
    }
    int line = pastA > 0 && beforeB > 0 ? line(x - ax, y - ay, radius, dx, dy) : 0;
    return line > 0 || (line == 0 && touchExactly(x, y, radius, ax, ay, bx, by));
  }

  /** The sign of a sum of two products of differences; 0 where rounding may have made it. */
  private static int sign(double a, double b) {
    double bound = ROUNDING * (Math.abs(a) + Math.abs(b)) + Double.MIN_NORMAL;
    return a + b > bound ? 1 : a + b < -bound ? -1 : 0;
  }

  /** 1 where the line along d comes within the radius of a point, -1 where not, 0 if unsure. */
  private static int line(double fx, double fy, double radius, double dx, double dy) {
    double square = dx * dx + dy * dy;
    double reach = radius * Math.sqrt(square);
    double offset = Math.abs(dx * fy - dy * fx);
    double bound = ROUNDING * (Math.abs(dx * fy) + Math.abs(dy * fx) + reach) + Double.MIN_NORMAL;
    boolean sure = square > SMALLEST_SQUARE && Math.abs(reach - offset) > bound;
    return !sure ? 0 : reach > offset ? 1 : -1;
  }

  private static boolean containsExactly(
      double x, double y, double radius, double atX, double atY) {
    BigDecimal square = square(Orientation.difference(atX, x), Orientation.difference(atY, y));
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
