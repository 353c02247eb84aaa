package org.hificamsim.core.obstacle;

/**
 * Where sight lines are as high as an obstacle: all those from a point at height z to what is
 * between two heights of an upright line. At a share t of the way they are between z + t (low - z)
 * and z + t (high - z), so the shares at which any is between base and top are an interval.
 */
final class Slab {
  private Slab() {}

  /**
   * The share of the way from which on one of the lines is as high, 0 or more; infinite if none.
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

  /** The share of the way up to which one of the lines is as high, 1 or less. */
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

  /** The coordinate at a share of the way; the ends as they are. */
  static double at(double from, double to, double share) {
    return share == 1 ? to : from + share * (to - from);
  }
}
