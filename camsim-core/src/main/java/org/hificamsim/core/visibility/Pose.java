package org.hificamsim.core.visibility;

/**
 * The position and heading of a camera.
 *
 * @param x the x coordinate, in metres
 * @param y the y coordinate, in metres
 * @param heading the heading, in radians, 0 is +y and pi/2 is +x; not normalised
 * @param headingX the x component of the unit vector along the heading
 * @param headingY the y component of that unit vector
 */
public record Pose(double x, double y, double heading, double headingX, double headingY) {
  /** Creates a pose. */
  public static Pose of(double x, double y, double heading) {
    return new Pose(x, y, heading, Math.sin(heading), Math.cos(heading));
  }

  /** The pose at the same position, turned by an angle in radians. */
  public Pose turned(double angle) {
    return angle == 0 ? this : of(x, y, heading + angle);
  }

  /** The squared distance to a point, in square metres. */
  public double squaredDistance(double pointX, double pointY) {
    double dx = pointX - x;
    double dy = pointY - y;
    return dx * dx + dy * dy;
  }

  /** The distance to a point, in metres. */
  public double distance(double pointX, double pointY) {
    return Math.sqrt(squaredDistance(pointX, pointY));
  }

  /**
   * Whether a point is in a sector around the heading, or on its border.
   *
   * @param cosine the cosine of half the sector's angle
   */
  boolean isInSector(double cosine, double pointX, double pointY) {
    return along(pointX, pointY) >= cosine * distance(pointX, pointY);
  }

  /** The distance of a point ahead of the pose, in metres; below 0 for a point behind it. */
  double along(double pointX, double pointY) {
    double dx = pointX - x;
    double dy = pointY - y;
    return dx * headingX + dy * headingY;
  }

  /**
   * The distance of a point to the right of the pose, in metres; below 0 for a point to its left.
   */
  double aside(double pointX, double pointY) {
    return (pointX - x) * headingY - (pointY - y) * headingX;
  }

  /**
   * The angle between the heading and a point, in radians, computed like CamSim; NaN for the pose's
   * own position, and if rounding takes the cosine past 1.
   */
  public double offAxis(double pointX, double pointY) {
    double dx = pointX - x;
    double dy = pointY - y;
    double length = Math.sqrt(dx * dx + dy * dy);
    return ArcCosine.of(headingX * (dx / length) + headingY * (dy / length));
  }
}
