package org.hificamsim.network.agent;

import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.detection.camsim.CamSimVisibilityDetection;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.Targets;
import org.hificamsim.core.world.World;

/**
 * What each camera saw at its last look, and with what confidence (sections 6.1 and 6.2). The
 * targets that a camera sees are walked through in the order in which they became visible to it.
 *
 * <p>A target is visible when it is within reach and opening angle and the detection model's value
 * is above 0 and reaches the threshold. Values are clamped to [0, 1] but for CamSim's own
 * visibility, which exceeds 1 close to cameras of a range below 1 m.
 */
public final class Sightings {
  private final Cameras cameras;
  private final Targets targets;
  private final DetectionModel model;
  private final double threshold;
  private final boolean clamped;
  private final double[] confidence;
  private final InsertionOrder[] visible;

  public Sightings(World world, Detection detection) {
    cameras = world.cameras();
    targets = world.targets();
    model = detection.model();
    threshold = detection.threshold();
    clamped = !(model instanceof CamSimVisibilityDetection);
    confidence = new double[cameras.count() * targets.count()];
    visible = new InsertionOrder[cameras.count()];
    for (int camera = 0; camera < visible.length; camera++) {
      visible[camera] = new InsertionOrder(targets.count());
    }
  }

  /** The camera looks at every target present. */
  public void look(int camera) {
    ZoomLevel zoom = cameras.zoom(camera, cameras.level(camera));
    InsertionOrder seen = visible[camera];
    int row = camera * targets.count();
    for (int target = 0; target < targets.count(); target++) {
      if (!targets.present(target)) {
        continue;
      }
      double value = value(camera, target, zoom);
      if (value > 0) {
        seen.add(target);
        confidence[row + target] = value;
      } else {
        seen.remove(target);
        confidence[row + target] = 0;
      }
    }
  }

  /** A camera loses sight of a target, whatever its next look brings. */
  public void forget(int camera, int target) {
    visible[camera].remove(target);
    confidence[camera * targets.count() + target] = 0;
  }

  /** How sure the camera is of the target; 0 where it does not see it. */
  public double confidence(int camera, int target) {
    return confidence[camera * targets.count() + target];
  }

  public boolean sees(int camera, int target) {
    return visible[camera].contains(target);
  }

  /** The targets that the camera sees. */
  public InsertionOrder visible(int camera) {
    return visible[camera];
  }

  private double value(int camera, int target, ZoomLevel zoom) {
    double dx = targets.x(target) - cameras.x(camera);
    double dy = targets.y(target) - cameras.y(camera);
    double distance = Math.sqrt(dx * dx + dy * dy);
    if (distance > zoom.radius()) {
      return 0;
    }
    boolean allRound = zoom.viewingAngle() >= 2 * Math.PI;
    double offAxis = allRound && !model.dependsOnBearing() ? 0 : offAxis(camera, dx, dy, distance);
    if (!allRound && !(offAxis < zoom.viewingAngle() / 2)) {
      return 0;
    }
    double value = model.confidence(targets.size(target), distance, offAxis, zoom);
    if (!(value >= threshold)) {
      return 0;
    }
    return clamped ? DetectionModel.clamp(value) : value;
  }

  /** NaN on the camera's own position, or where rounding takes the cosine past 1 (quirk Q9). */
  private double offAxis(int camera, double dx, double dy, double distance) {
    return Math.acos(
        cameras.headingX(camera) * (dx / distance) + cameras.headingY(camera) * (dy / distance));
  }
}
