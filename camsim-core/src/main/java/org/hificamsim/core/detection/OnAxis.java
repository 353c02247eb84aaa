package org.hificamsim.core.detection;

/** A model as it is along the heading: it does not look at the bearing. */
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
