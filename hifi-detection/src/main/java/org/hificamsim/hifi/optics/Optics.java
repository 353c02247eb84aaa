package org.hificamsim.hifi.optics;

import org.hificamsim.core.detection.ZoomLevel;

/**
 * A camera's sensor and lens, which determine the radius of the field of view from the focal length
 * z (Eqs 3.1 and 3.2, where the thesis writes res for the sensor's width).
 *
 * @param sensorWidth width of the image sensor, in metres, above 0
 * @param longestFocalLength focal length at the narrowest zoom of a camera whose mount height is
 *     not known, in metres, above 0
 */
public record Optics(double sensorWidth, double longestFocalLength) {
  /** The width of a picture if the scenario does not give one: full high definition. */
  private static final int DEFAULT_PIXELS = 1920;

  /** Returns the angle of view in radians, in (0, pi), at a focal length above 0 (Eq 3.1). */
  public double angleOfView(double focalLength) {
    return 2 * StrictMath.atan(sensorWidth / (2 * focalLength));
  }

  /**
   * Returns the radius of the field of view of a camera at this height above the target plane (Eq
   * 3.2).
   */
  public double radius(double focalLength, double mountHeight) {
    return mountHeight * StrictMath.tan(angleOfView(focalLength) / 2);
  }

  /**
   * Returns the mount height at which this focal length gives this radius (Eqs 3.1 and 3.2,
   * solved).
   */
  public double mountHeight(double radius, double focalLength) {
    return 2 * focalLength * radius / sensorWidth;
  }

  /**
   * Returns the focal length that gives this radius, above 0, from this height (Eqs 3.1 and 3.2,
   * solved).
   */
  public double focalLength(double radius, double mountHeight) {
    return mountHeight * sensorWidth / (2 * radius);
  }

  /**
   * Returns the horizontal pixels per metre, W / (2 d tan(theta / 2)); infinite at distance 0.
   *
   * @param distance the distance in metres
   */
  public double pixelsPerMetre(ZoomLevel zoom, double distance) {
    int pixels = zoom.pixels() > 0 ? zoom.pixels() : DEFAULT_PIXELS;
    double angle = zoom.hasLens() ? zoom.angleOfView() : angleOfView(focalLength(zoom));
    return pixels / (2 * distance * StrictMath.tan(angle / 2));
  }

  /**
   * Returns the focal length of a zoom level in metres. If the scenario names a lens, the result
   * has the same angle of view on this sensor (Eq 3.1), so that a target fills the same share of
   * the picture. Otherwise it follows from the radius and the mount height. If the height is
   * unknown (NaN), it is inversely proportional to the radius, and the narrowest level has the
   * longest focal length.
   *
   * <p>A radius of 0 would need an infinite focal length; the longest one is used instead. No
   * result depends on it, because such a level sees only the spot under the camera.
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
