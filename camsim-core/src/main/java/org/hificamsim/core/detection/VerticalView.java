package org.hificamsim.core.detection;

/**
 * The vertical part of a camera's view.
 *
 * @param z height of the lens above the ground, metres, 0 or more; NaN in a flat world
 * @param tilt of the optical axis below the horizon, radians, [-pi/2, pi/2]
 * @param angle the vertical angle of view, radians, (0, pi); NaN if the view has no vertical limit
 */
public record VerticalView(double z, double tilt, double angle) {
  /** The vertical view in a world without heights. */
  public static final VerticalView FLAT = new VerticalView(Double.NaN, 0, Double.NaN);

  /** Whether the world has no heights. */
  public boolean flat() {
    return Double.isNaN(z);
  }
}
