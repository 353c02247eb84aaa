package org.hificamsim.core.engine;

import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.Targets;

/**
 * The geometry of sectors and circles: which targets are within a camera's reach and opening angle.
 *
 * <p>Both borders belong to the field of view. A target on the camera's own position is inside.
 */
final class FieldOfView {
  private final Cameras cameras;
  private final Targets targets;

  FieldOfView(Cameras cameras, Targets targets) {
    this.cameras = cameras;
    this.targets = targets;
  }

  /** Square metres. */
  double squaredDistance(int camera, int target) {
    double dx = targets.x(target) - cameras.x(camera);
    double dy = targets.y(target) - cameras.y(camera);
    return dx * dx + dy * dy;
  }

  /** Whether the target is within the opening angle. */
  boolean withinAngle(int camera, int level, int target) {
    double angle = cameras.zoom(camera, level).viewingAngle();
    if (angle >= 2 * Math.PI) {
      return true;
    }
    double dx = targets.x(target) - cameras.x(camera);
    double dy = targets.y(target) - cameras.y(camera);
    double along = dx * cameras.headingX(camera) + dy * cameras.headingY(camera);
    return along >= Math.cos(angle / 2) * Math.sqrt(dx * dx + dy * dy);
  }

  /** Whether the target is within reach and angle. */
  boolean contains(int camera, int level, int target) {
    ZoomLevel zoom = cameras.zoom(camera, level);
    return Math.sqrt(squaredDistance(camera, target)) <= zoom.radius()
        && withinAngle(camera, level, target);
  }

  /**
   * The angle between heading and target, radians, computed as CamSim does; NaN on the camera's own
   * position, or where rounding takes the cosine past 1.
   */
  double offAxis(int camera, int target) {
    return Math.acos(cosine(camera, target));
  }

  /** The cosine of that angle, as computed; NaN on the camera's own position. */
  double cosine(int camera, int target) {
    double dx = targets.x(target) - cameras.x(camera);
    double dy = targets.y(target) - cameras.y(camera);
    double length = Math.sqrt(dx * dx + dy * dy);
    return cameras.headingX(camera) * (dx / length) + cameras.headingY(camera) * (dy / length);
  }
}
