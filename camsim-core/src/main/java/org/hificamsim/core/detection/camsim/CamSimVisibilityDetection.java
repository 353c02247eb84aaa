package org.hificamsim.core.detection.camsim;

import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.ZoomLevel;

/**
 * The visibility that CamSim itself computes: {@code 1 / (d + (R - d) / R)}, times {@code (A/2 -
 * offAxis) / (A/2)} unless the camera sees in all directions. It is 0 if the angle is NaN or not
 * below A/2, so that a target exactly on the camera is invisible (behaviour 6.1). The default
 * threshold detects every value above 0.
 */
public final class CamSimVisibilityDetection implements DetectionModel {
  private static final double ALL_ROUND_DEGREES = 360;

  @Override
  public String name() {
    return "camsim-visibility";
  }

  @Override
  public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
    double half = zoom.viewingAngle() / 2;
    if (!(offAxis < half)) {
      return 0;
    }
    double byDistance = 1 / (distance + (zoom.radius() - distance) / zoom.radius());
    return dependsOnBearing(zoom) ? byDistance * ((half - offAxis) / half) : byDistance;
  }

  @Override
  public double defaultThreshold() {
    return Double.MIN_VALUE;
  }

  @Override
  public boolean dependsOnBearing() {
    return true;
  }

  @Override
  public boolean dependsOnBearing(ZoomLevel zoom) {
    return Math.toDegrees(zoom.viewingAngle()) != ALL_ROUND_DEGREES;
  }

  /** The value itself, which exceeds 1 close to cameras of a range below 1 m. */
  @Override
  public double reported(double value) {
    return value;
  }

  @Override
  public boolean flat() {
    return true;
  }
}
