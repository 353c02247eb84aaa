package org.hificamsim.core.obstacle;

import java.math.BigDecimal;

/**
 * On which side of a line a point is, exactly: the sign of a determinant. A filter after Shewchuk
 * ("Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates", 1997)
 * decides nearly always. Points so near to the line that it does not are decided by signs, by
 * products with their rounding errors where the differences of coordinates are doubles (as on a
 * lattice), and only else by decimals of any length, which alone allocate.
 */
final class Orientation {
  /** (3 + 16 u) u for u = 2^-53: Shewchuk's bound of what rounding adds to the determinant. */
  private static final double ROUNDING = 3.3306690738754716e-16;

  /** Products between these neither lose their rounding error below a double's range nor end. */
  private static final double SMALLEST = 1e-250;

  private static final double LARGEST = 1e250;

  private Orientation() {}

  /** Above 0 where c is to the left of the line from a to b, 0 on it, below 0 to its right. */
  static int of(double ax, double ay, double bx, double by, double cx, double cy) {
    double left = (ax - cx) * (by - cy);
    double right = (ay - cy) * (bx - cx);
    double bound = ROUNDING * (Math.abs(left) + Math.abs(right)) + Double.MIN_NORMAL;
    double determinant = left - right;
    if (determinant > bound) {
      return 1;
    }
    return determinant < -bound ? -1 : near(ax, ay, bx, by, cx, cy);
  }

  private static int near(double ax, double ay, double bx, double by, double cx, double cy) {
    int left = sign(ax - cx) * sign(by - cy);
    int right = sign(ay - cy) * sign(bx - cx);
    if (left != right || left == 0) {
      return Integer.compare(left, right);
    }
    boolean whole = whole(ax, cx) && whole(by, cy) && whole(ay, cy) && whole(bx, cx);
    double product = (ax - cx) * (by - cy);
    boolean inRange = Math.abs(product) > SMALLEST && Math.abs(product) < LARGEST;
    return whole && inRange
        ? compare(ax - cx, by - cy, ay - cy, bx - cx)
        : exact(ax, ay, bx, by, cx, cy);
  }

  private static int sign(double value) {
    return value > 0 ? 1 : value < 0 ? -1 : 0;
  }

  /** Whether a difference of two doubles is a double. */
  private static boolean whole(double a, double b) {
    double difference = a - b;
    double subtracted = a - difference;
    return a - (difference + subtracted) + (subtracted - b) == 0;
  }

  /**
   * Compares a b with c d. Where the rounded products are the same, what was rounded off decides.
   */
  private static int compare(double a, double b, double c, double d) {
    double left = a * b;
    double right = c * d;
    return left == right
        ? Double.compare(Math.fma(a, b, -left) + 0.0, Math.fma(c, d, -right) + 0.0)
        : Double.compare(left, right);
  }

  private static int exact(double ax, double ay, double bx, double by, double cx, double cy) {
    BigDecimal left = difference(ax, cx).multiply(difference(by, cy));
    return left.compareTo(difference(ay, cy).multiply(difference(bx, cx)));
  }

  static BigDecimal difference(double a, double b) {
    return new BigDecimal(a).subtract(new BigDecimal(b));
  }
}
