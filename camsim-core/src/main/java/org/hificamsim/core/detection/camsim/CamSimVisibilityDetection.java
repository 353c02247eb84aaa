package org.hificamsim.core.detection.camsim;

import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.ZoomLevel;

/**
 * The visibility that the CamSim simulator itself computes: {@code 1 / (d + (R - d) / R)}, times
 * {@code (A/2 - offAxis) / (A/2)} unless the camera sees all round. An angle that is no number, or
 * not below A/2, makes it 0, so that a target exactly on the camera is invisible (behaviour 6.1).
 * Visible is what is above 0, which the default threshold says.
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
    double near = 1 / (distance + (zoom.radius() - distance) / zoom.radius());
    return dependsOnBearing(zoom) ? near * ((half - offAxis) / half) : near;
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

  /** The value itself: it exceeds 1 close to cameras of a range below 1 m. */
  @Override
  public double reported(double value) {
    return value;
  }

  @Override
  public boolean flat() {
    return true;
  }
}
