package org.hificamsim.core.obstacle;

/**
 * A measure of direction that needs no trigonometry, and equal sectors of it. The measure is the
 * position on the diamond |x| + |y| = 1: it rises counterclockwise from 0 at -x by 1 in each
 * quarter, so that opposite directions differ by 2.
 */
final class Sector {
  /** The measure of a full turn. */
  static final double ROUND = 4;

  /** A bound on the rounding error of a measure; far smaller than any sector. */
  static final double ROUNDING = 1e-12;

  private Sector() {}

  /** The measure of a direction, in [0, 4]; NaN for (0, 0). */
  static double measure(double dx, double dy) {
    return 2 + Math.copySign(1 - dx / (Math.abs(dx) + Math.abs(dy)), dy);
  }

  /** The x coordinate on the diamond at a measure in [0, 4] or slightly beyond. */
  static double x(double measure) {
    return measure < 2 ? measure - 1 : 3 - measure;
  }

  /** The y coordinate on the diamond at a measure in [0, 4] or slightly beyond. */
  static double y(double measure) {
    return measure < 2 ? Math.abs(measure - 1) - 1 : 1 - Math.abs(3 - measure);
  }
}
