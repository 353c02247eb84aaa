package org.hificamsim.bridge.camsim;

/**
 * The direction, opening angle and range of a camera.
 *
 * @param heading the heading in radians, 0 is +y and pi/2 is +x; not normalised
 * @param angle the full opening angle, in radians
 * @param range the range in metres
 */
public record Aim(double heading, double angle, double range) {
  private static final double TOLERANCE = 1e-9;
  private static final double FULL_TURN = 2 * Math.PI;

  /** Returns whether heading and angle are equal, apart from rounding and full turns. */
  boolean isNear(Aim other) {
    double turn = Math.IEEEremainder(heading - other.heading, FULL_TURN);
    return Math.abs(turn) <= TOLERANCE * Math.max(1, Math.abs(other.heading))
        && Math.abs(angle - other.angle) <= TOLERANCE * other.angle;
  }
}
