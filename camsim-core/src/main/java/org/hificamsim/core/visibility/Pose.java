package org.hificamsim.core.visibility;

/**
 * Where a camera stands and which way it looks.
 *
 * @param x metres
 * @param y metres
 * @param heading radians, 0 is +y and pi/2 is +x; not normalised
 * @param headingX the x component of the unit vector along the heading
 * @param headingY its y component
 */
public record Pose(double x, double y, double heading, double headingX, double headingY) {
  /** A pose with the unit vector that belongs to its heading. */
  public static Pose of(double x, double y, double heading) {
    return new Pose(x, y, heading, Math.sin(heading), Math.cos(heading));
  }

  /** The same place, turned by an angle, radians; a whole pose as it is for 0. */
  public Pose turned(double angle) {
    return angle == 0 ? this : of(x, y, heading + angle);
  }

  /** The squared distance to a point, square metres. */
  public double squaredDistance(double atX, double atY) {
    double dx = atX - x;
    double dy = atY - y;
    return dx * dx + dy * dy;
  }

  /** The distance to a point, metres. */
  public double distance(double atX, double atY) {
    return Math.sqrt(squaredDistance(atX, atY));
  }

  /**
   * Whether a point is in a sector around the heading, or on its border.
   *
   * @param cosine of half the sector's angle
   */
  boolean isInSector(double cosine, double atX, double atY) {
    return along(atX, atY) >= cosine * distance(atX, atY);
  }

  /** How far ahead of the pose a point is, metres; below 0 behind it. */
  double along(double atX, double atY) {
    double dx = atX - x;
    double dy = atY - y;
    return dx * headingX + dy * headingY;
  }

  /** How far to the right of the pose a point is, metres; below 0 to its left. */
  double aside(double atX, double atY) {
    return (atX - x) * headingY - (atY - y) * headingX;
  }

  /**
   * The angle between the heading and a point, radians, computed as CamSim does; NaN for the pose's
   * own position, or where rounding takes the cosine past 1.
   */
  public double offAxis(double atX, double atY) {
    double dx = atX - x;
    double dy = atY - y;
    double length = Math.sqrt(dx * dx + dy * dy);
    return StrictMath.acos(headingX * (dx / length) + headingY * (dy / length));
  }
}
