package org.hificamsim.core.obstacle;

/**
 * The part of the way at which lines of sight are between the base and the top of an obstacle. The
 * lines lead from a point at height z to an upright line between two heights; at a share t of the
 * way they are between z + t (low - z) and z + t (high - z), so these shares are an interval.
 */
final class Slab {
  private Slab() {}

  /**
   * The first share of the way, 0 or more, at which any line is between base and top; infinite if
   * none.
   */
  static double start(double z, double low, double high, double base, double top) {
    double start = 0;
    if (low < z) {
      start = Math.max(start, (z - top) / (z - low));
    }
    if (high > z) {
      start = Math.max(start, (base - z) / (high - z));
    }
    boolean levelAbove = low == z && z > top;
    boolean levelBelow = high == z && z < base;
    return levelAbove || levelBelow ? Double.POSITIVE_INFINITY : start;
  }

  /** The last share of the way, 1 or less, at which any line is between base and top. */
  static double end(double z, double low, double high, double base, double top) {
    double end = 1;
    if (low > z) {
      end = Math.min(end, (top - z) / (low - z));
    }
    if (high < z) {
      end = Math.min(end, (z - base) / (z - high));
    }
    return end;
  }

  /** The coordinate at a share of the way; exact at both ends. */
  static double at(double from, double to, double share) {
    return share == 1 ? to : from + share * (to - from);
  }
}
