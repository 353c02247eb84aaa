package org.hificamsim.core.detection;

/** Certain inside the field of view: the upper bound on what any model detects. */
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
