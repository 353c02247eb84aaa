package org.hificamsim.runs;

import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.ZoomLevel;

/** A detection model under another name: one model, used twice, told apart in result files. */
public record RenamedDetection(DetectionModel model, String name) implements DetectionModel {
  @Override
  public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
    return model.confidence(size, distance, offAxis, zoom);
  }

  @Override
  public double defaultThreshold() {
    return model.defaultThreshold();
  }

  @Override
  public boolean dependsOnBearing() {
    return model.dependsOnBearing();
  }
}
