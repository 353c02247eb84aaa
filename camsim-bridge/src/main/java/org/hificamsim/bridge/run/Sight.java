package org.hificamsim.bridge.run;

import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.detection.camsim.CamSimVisibilityDetection;

/**
 * What cameras see: an object is visible when it is in range, in the angle, and the detection
 * model's value is above 0 and reaches the threshold. Range, angle and confidence are computed as
 * CamSim does, so that its own visibility, taken as the model, gives its own numbers.
 *
 * <p>Confidences are clamped to [0, 1], but for CamSim's own visibility, which exceeds 1 close to
 * cameras of a range below 1 m.
 */
final class Sight {
  private final Detection detection;
  private final double size;
  private final boolean clamped;

  /**
   * @param size of every object, metres
   */
  Sight(Detection detection, double size) {
    this.detection =
        new Detection(detection.model(), Math.max(detection.threshold(), Double.MIN_VALUE));
    this.size = size;
    this.clamped = !(detection.model() instanceof CamSimVisibilityDetection);
  }

  /** The confidence of a camera at a level for an object at a place; 0 where it is not visible. */
  double confidence(LiveCamera camera, ZoomLevel zoom, double x, double y) {
    double value = value(camera, zoom, x, y);
    if (!(value >= detection.threshold())) {
      return 0;
    }
    return clamped ? DetectionModel.clamp(value) : value;
  }

  /** The model's own value, whatever the threshold; 0 out of range or angle. */
  double value(LiveCamera camera, ZoomLevel zoom, double x, double y) {
    double dx = x - camera.x();
    double dy = y - camera.y();
    double distance = Math.sqrt(dx * dx + dy * dy);
    if (distance > zoom.radius()) {
      return 0;
    }
    boolean allRound = zoom.viewingAngle() >= 2 * Math.PI;
    boolean byBearing = !allRound || detection.model().dependsOnBearing();
    double offAxis = byBearing ? camera.offAxis(dx, dy, distance) : 0;
    return allRound || offAxis < zoom.viewingAngle() / 2
        ? detection.model().confidence(size, distance, offAxis, zoom)
        : 0;
  }

  /** Whether a camera at one level is proven to see whatever it would see at the other. */
  boolean dominates(ZoomLevel zoom, ZoomLevel other) {
    if (detection.model().dependsOnBearing()) {
      return zoom.equals(other);
    }
    return detection.distances(size, zoom).includes(detection.distances(size, other));
  }
}
