package org.example;

import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.ZoomLevel;

/**
 * A detection model of one's own: contrast fades with distance in fog, after Koschmieder (1924), so
 * that at the meteorological visibility 2% of it is left, at any zoom level.
 */
public final class FogDetection implements DetectionModel {
  private static final double VISIBILITY = 4; // metres
  private static final double MIN_CONTRAST = 0.02;

  @Override
  public String name() {
    return "fog";
  }

  @Override
  public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
    return Math.exp(Math.log(MIN_CONTRAST) * distance / VISIBILITY);
  }

  @Override
  public double defaultThreshold() {
    return MIN_CONTRAST;
  }
}
