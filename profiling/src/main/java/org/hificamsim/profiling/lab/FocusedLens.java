package org.hificamsim.profiling.lab;

/**
 * A thin lens focused at one distance; gives the width of the image of a point.
 *
 * @param focalLength z, in metres
 * @param aperture f-number N; 0 for a pinhole, which is sharp everywhere
 * @param focus the distance at which the image is sharp, in metres, above the focal length
 */
record FocusedLens(double focalLength, double aperture, double focus) {
  private static final double WAVELENGTH = 550e-9;

  /**
   * Returns the diameter on the sensor, in metres, of the image of a point at a distance in metres:
   * the circle of confusion, {@code (z / N) * |s - f| / s * z / (f - z)}.
   */
  double circleOfConfusion(double distance) {
    if (aperture == 0) {
      return 0;
    }
    double opening = focalLength / aperture;
    return opening
        * Math.abs(distance - focus)
        / distance
        * focalLength
        / Math.max(focus - focalLength, 1e-3);
  }

  /** Returns the standard deviation of diffraction on the sensor, in metres: 0.42 wavelength N. */
  double diffraction() {
    return 0.42 * WAVELENGTH * aperture;
  }
}
