package org.hificamsim.core.obstacle;

/**
 * Directions by a measure of angle that needs no trigonometry, and the sectors of all round. The
 * measure is that of the diamond |x| + |y| = 1: it rises counterclockwise from 0 at -x by 1 in each
 * quarter, and opposite directions differ by 2.
 */
final class Sector {
  /** The measure of all round. */
  static final double ROUND = 4;

  /** More than what rounding does to a measure; less than any sector by far. */
  static final double ROUNDING = 1e-12;

  private Sector() {}

  /** The measure of a direction, in [0, 4]; NaN of (0, 0). */
  static double measure(double dx, double dy) {
    return 2 + Math.copySign(1 - dx / (Math.abs(dx) + Math.abs(dy)), dy);
  }

  /** The x of the diamond's point at a measure in [0, 4], or a little beyond. */
  static double x(double measure) {
    return measure < 2 ? measure - 1 : 3 - measure;
  }

  /** The y of the diamond's point at a measure in [0, 4], or a little beyond. */
  static double y(double measure) {
    return measure < 2 ? Math.abs(measure - 1) - 1 : 1 - Math.abs(3 - measure);
  }
}
