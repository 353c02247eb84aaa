package org.hificamsim.core.detection.camsim;

import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.ZoomLevel;

/**
 * CamSim's published confidence, which depends on the zoom radius only (Eq 6.2) and is negative at
 * the widest zoom.
 */
public final class CamSimStandardDetection implements DetectionModel {
  @Override
  public String name() {
    return "camsim-standard";
  }

  @Override
  public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
    return 0.95 * (1 - zoom.radius() / zoom.widestRadius()) - 0.15;
  }

  @Override
  public double defaultThreshold() {
    return CamSimRangeDetection.THRESHOLD;
  }

  @Override
  public boolean flat() {
    return true;
  }
}
