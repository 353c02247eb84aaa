package org.hificamsim.hifi.density;

import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.hifi.optics.Optics;

/** How many pixels of a camera's picture a metre takes up. */
final class PixelDensity {
  /** The width of a picture where the scenario does not say: full high definition. */
  static final int DEFAULT_PIXELS = 1920;

  private PixelDensity() {}

  /**
   * Pixels per metre across, W / (2 d tan(theta / 2)); infinite at distance 0.
   *
   * @param optics give the angle of view where the scenario names no lens
   * @param distance metres
   */
  static double of(ZoomLevel zoom, Optics optics, double distance) {
    int pixels = zoom.pixels() > 0 ? zoom.pixels() : DEFAULT_PIXELS;
    double angle =
        zoom.hasLens() ? zoom.angleOfView() : optics.angleOfView(optics.focalLength(zoom));
    return pixels / (2 * distance * StrictMath.tan(angle / 2));
  }
}
