package org.hificamsim.core.detection;

/**
 * The vertical part of a camera's view.
 *
 * @param z height of the lens above the ground, in metres, 0 or more; NaN in a flat world
 * @param tilt the tilt of the optical axis below the horizon, in radians, [-pi/2, pi/2]
 * @param angle the vertical angle of view, in radians, (0, pi); NaN if the view has no vertical
 *     limit
 */
public record VerticalView(double z, double tilt, double angle) {
  /** The vertical view in a world without heights. */
  public static final VerticalView FLAT = new VerticalView(Double.NaN, 0, Double.NaN);

  /**
   * Returns the height of the picture of an upright target on the optical axis, in focal lengths.
   * If the view has no vertical limit, the lens is assumed to point at the target.
   *
   * @param distance the distance over the ground, in metres
   * @param height the height of the target, in metres
   */
  double heightInPicture(double distance, double height) {
    double axis = Double.isNaN(angle) ? StrictMath.atan2(z - height / 2, distance) : tilt;
    double sine = StrictMath.sin(axis);
    double cosine = StrictMath.cos(axis);
    double feet = distance * cosine + z * sine;
    double head = distance * cosine + (z - height) * sine;
    return feet > 0 && head > 0 ? distance * height / (feet * head) : Double.POSITIVE_INFINITY;
  }

  /** Whether the world has no heights. */
  public boolean flat() {
    return Double.isNaN(z);
  }
}
