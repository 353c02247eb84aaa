package org.hificamsim.core.detection;

/** Detects everything inside the field of view: an upper bound for all models. */
public final class GeometricDetection implements DetectionModel {
  @Override
  public String name() {
    return "geometric";
  }

  @Override
  public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
    return 1;
  }
}
