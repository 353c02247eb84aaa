package org.example.user;

import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.ZoomLevel;

/** Detects targets nearer than a metre. */
public final class UserDetection implements DetectionModel {
  @Override
  public String name() {
    return "user:near";
  }

  @Override
  public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
    return distance < 1 ? 1 : 0;
  }
}
