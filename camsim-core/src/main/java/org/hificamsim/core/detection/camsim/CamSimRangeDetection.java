package org.hificamsim.core.detection.camsim;

import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.ZoomLevel;

/**
 * The formula of the coverage study's simulator: {@code 0.95 (b / (r d)) - 0.15} with b = 15 square
 * metres, at least 0; a target closer than a nanometre is certain.
 */
public final class CamSimRangeDetection implements DetectionModel {
  /**
   * A threshold that comes close to the CamSim column of Table 8.1, which no threshold reproduces.
   */
  static final double THRESHOLD = 0.35;

  private static final double B = 15;
  private static final double CERTAIN_WITHIN = 1e-9;

  @Override
  public String name() {
    return "camsim-range";
  }

  @Override
  public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
    if (distance < CERTAIN_WITHIN) {
      return 1;
    }
    return Math.max(0, 0.95 * (B / (zoom.radius() * distance)) - 0.15);
  }

  @Override
  public double defaultThreshold() {
    return THRESHOLD;
  }

  @Override
  public boolean flat() {
    return true;
  }
}
