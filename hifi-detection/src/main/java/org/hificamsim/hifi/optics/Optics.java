package org.hificamsim.hifi.optics;

import org.hificamsim.core.detection.ZoomLevel;

/**
 * A camera's sensor and lens, which tie the radius of the field of view to the focal length z (Eqs
 * 3.1 and 3.2, with the sensor's width as the thesis's res).
 *
 * @param sensorWidth width of the image sensor, metres, above 0
 * @param longestFocalLength focal length at the narrowest zoom of a camera whose mount height is
 *     not known, metres, above 0
 */
public record Optics(double sensorWidth, double longestFocalLength) {
  /** The angle of view at a focal length above 0, radians, (0, pi) (Eq 3.1). */
  public double angleOfView(double focalLength) {
    return 2 * StrictMath.atan(sensorWidth / (2 * focalLength));
  }

  /** The radius of the field of view of a camera this high over the target plane (Eq 3.2). */
  public double radius(double focalLength, double mountHeight) {
    return mountHeight * StrictMath.tan(angleOfView(focalLength) / 2);
  }

  /** The mount height at which this focal length gives this radius: Eqs 3.1, 3.2 solved. */
  public double mountHeight(double radius, double focalLength) {
    return 2 * focalLength * radius / sensorWidth;
  }

  /** The focal length that gives this radius, above 0, from this height: Eqs 3.1, 3.2 solved. */
  public double focalLength(double radius, double mountHeight) {
    return mountHeight * sensorWidth / (2 * radius);
  }

  /**
   * The focal length of a zoom level, metres: from the angle of view of the scenario's lens, on
   * this sensor (Eq 3.1), so that a target takes up the same part of the picture. Without a lens
   * from its radius and the mount height; where the height is not known (NaN), in inverse
   * proportion to the radius, so that the narrowest level has the longest focal length.
   *
   * <p>A radius of 0 would ask for an infinite focal length; it counts as the longest one instead.
   * Such a level sees the spot under the camera alone, so nothing depends on it.
   */
  public double focalLength(ZoomLevel zoom) {
    if (zoom.hasLens()) {
      return sensorWidth / (2 * StrictMath.tan(zoom.angleOfView() / 2));
    }
    if (zoom.radius() == 0) {
      return longestFocalLength;
    }
    return Double.isNaN(zoom.mountHeight())
        ? longestFocalLength * zoom.narrowestRadius() / zoom.radius()
        : focalLength(zoom.radius(), zoom.mountHeight());
  }
}
