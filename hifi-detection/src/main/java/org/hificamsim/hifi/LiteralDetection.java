package org.hificamsim.hifi;

import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.hifi.feature.LinearAbstraction;
import org.hificamsim.hifi.optics.Optics;

/**
 * Eq 6.1 exactly as printed: the detector line applied to {@code -log10(PIP)} rather than to PIP,
 * so that the confidence grows with distance and leaves [0, 1]. {@link HiFiDetection} is the
 * consistent reading.
 *
 * @param name the name on the command line and in result files
 * @param sum the printed weights, whose weighted sum is the confidence
 * @param optics determine the focal length of a zoom level
 * @param defaultThreshold the confidence from which a target counts as detected
 */
public record LiteralDetection(
    String name, LinearAbstraction sum, Optics optics, double defaultThreshold)
    implements OpticalDetection {
  @Override
  public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
    return sum.negativeLogPip(size, distance, optics.focalLength(zoom));
  }
}
