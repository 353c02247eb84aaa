package org.hificamsim.hifi.density;

import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.hifi.OpticalDetection;
import org.hificamsim.hifi.optics.Optics;

/**
 * What a standard demands for a task: a target is detected where its place has so many pixels per
 * metre, whatever its size. The value is the share of the demanded density that is there, at most
 * 1, which is the threshold.
 *
 * @param demanded pixels per metre, above 0
 */
record StandardDetection(String name, double demanded, Optics optics) implements OpticalDetection {
  @Override
  public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
    return Math.min(1, PixelDensity.of(zoom, optics, distance) / demanded);
  }

  @Override
  public double defaultThreshold() {
    return 1;
  }
}
