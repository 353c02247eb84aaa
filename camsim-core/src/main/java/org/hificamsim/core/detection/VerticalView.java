package org.hificamsim.core.detection;

/**
 * How a camera looks up and down.
 *
 * @param z height of the lens above the ground, metres, 0 or more; NaN in a flat world
 * @param tilt of the optical axis below the horizon, radians, [-pi/2, pi/2]
 * @param angle what the lens has in its picture from top to bottom, radians, (0, pi); NaN where
 *     nothing limits the view up and down
 */
public record VerticalView(double z, double tilt, double angle) {
  /** In a world without heights. */
  public static final VerticalView FLAT = new VerticalView(Double.NaN, 0, Double.NaN);

  /** Whether the world has no heights. */
  public boolean flat() {
    return Double.isNaN(z);
  }
}
