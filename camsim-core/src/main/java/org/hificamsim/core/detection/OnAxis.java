package org.hificamsim.core.detection;

/** Evaluates a model on the optical axis and ignores the bearing. */
public record OnAxis(DetectionModel model) implements DetectionModel {
  @Override
  public String name() {
    return model.name();
  }

  @Override
  public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
    return model.confidence(size, distance, 0, zoom);
  }
}
