package org.hificamsim.hifi.density;

import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.hifi.OpticalDetection;
import org.hificamsim.hifi.optics.Optics;

/**
 * The target transfer probability function of night vision models: with N cycles on a target, two
 * pixels each, and r = N / N50, it is acquired with probability {@code r^E / (1 + r^E)}, where E =
 * 2.7 + 0.7 r. Its successor is the TTP metric (Optical Engineering 43(11), 2004).
 *
 * @param halfCycles N50, cycles on target for an even chance, above 0
 */
record TransferFunctionDetection(String name, double halfCycles, Optics optics)
    implements OpticalDetection {
  @Override
  public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
    return probability(size * PixelDensity.of(zoom, optics, distance) / 2 / halfCycles);
  }

  /** As 1 / (1 + r^-E), which stays a number for any ratio r of 0 or more. */
  static double probability(double ratio) {
    return 1 / (1 + Math.pow(ratio, -(2.7 + 0.7 * ratio)));
  }
}
