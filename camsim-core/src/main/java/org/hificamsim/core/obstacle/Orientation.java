package org.hificamsim.core.obstacle;

import java.math.BigDecimal;

/**
 * Decides exactly on which side of a line a point is: the sign of a determinant. A filter by
 * Shewchuk ("Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates",
 * 1997) decides almost always. Points too close to the line are decided by signs, then, if the
 * differences of coordinates are doubles (as on a lattice), by products with their rounding errors,
 * and otherwise by decimals of unlimited length, which allocate.
 */
final class Orientation {
  /** Shewchuk's bound of the rounding error of the determinant: (3 + 16 u) u for u = 2^-53. */
  private static final double ROUNDING = 3.3306690738754716e-16;

  /** The bounds between which the rounding errors of products neither underflow nor overflow. */
  private static final double SMALLEST = 1e-250;

  private static final double LARGEST = 1e250;

  private Orientation() {}

  /**
   * Returns a number above 0 if c is to the left of the line from a to b, 0 on it, else below 0.
   */
  static int of(double ax, double ay, double bx, double by, double cx, double cy) {
    double left = (ax - cx) * (by - cy);
    double right = (ay - cy) * (bx - cx);
    double bound = ROUNDING * (Math.abs(left) + Math.abs(right)) + Double.MIN_NORMAL;
    double determinant = left - right;
    if (determinant > bound) {
      return 1;
    }
    return determinant < -bound ? -1 : closeToLine(ax, ay, bx, by, cx, cy);
  }

  private static int closeToLine(double ax, double ay, double bx, double by, double cx, double cy) {
    int left = sign(ax - cx) * sign(by - cy);
    int right = sign(ay - cy) * sign(bx - cx);
    if (left != right || left == 0) {
      return Integer.compare(left, right);
    }
    boolean exactDifferences =
        isDifferenceExact(ax, cx)
            && isDifferenceExact(by, cy)
            && isDifferenceExact(ay, cy)
            && isDifferenceExact(bx, cx);
    double product = (ax - cx) * (by - cy);
    boolean inRange = Math.abs(product) > SMALLEST && Math.abs(product) < LARGEST;
    return exactDifferences && inRange
        ? compare(ax - cx, by - cy, ay - cy, bx - cx)
        : decidedByDecimals(ax, ay, bx, by, cx, cy);
  }

  private static int sign(double value) {
    return value > 0 ? 1 : value < 0 ? -1 : 0;
  }

  /** Whether the difference of two doubles is a double itself. */
  private static boolean isDifferenceExact(double a, double b) {
    double difference = a - b;
    double subtracted = a - difference;
    return a - (difference + subtracted) + (subtracted - b) == 0;
  }

  /** Compares a b with c d. If the rounded products are equal, their rounding errors decide. */
  private static int compare(double a, double b, double c, double d) {
    double left = a * b;
    double right = c * d;
    return left == right
        ? Double.compare(Math.fma(a, b, -left) + 0.0, Math.fma(c, d, -right) + 0.0)
        : Double.compare(left, right);
  }

  private static int decidedByDecimals(
      double ax, double ay, double bx, double by, double cx, double cy) {
    BigDecimal left = difference(ax, cx).multiply(difference(by, cy));
    return left.compareTo(difference(ay, cy).multiply(difference(bx, cx)));
  }

  static BigDecimal difference(double a, double b) {
    return new BigDecimal(a).subtract(new BigDecimal(b));
  }
}
