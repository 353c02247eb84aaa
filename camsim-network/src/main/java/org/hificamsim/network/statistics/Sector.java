package org.hificamsim.network.statistics;

import org.hificamsim.core.visibility.Pose;
import org.hificamsim.core.world.Cameras;

/**
 * A camera's field of view: a sector of a circle, or a whole circle.
 *
 * @param x of its centre, metres
 * @param y of its centre, metres
 * @param heading middle of the opening, radians, 0 is +y and pi/2 is +x
 * @param angle full opening, radians, (0, 2 pi]
 * @param radius metres, 0 or more
 */
record Sector(double x, double y, double heading, double angle, double radius) {
  /** What a camera sees now: nothing, of radius 0, while it moves blindly. */
  static Sector of(Cameras cameras, int camera) {
    Pose pose = cameras.pose(camera, view(cameras, camera));
    double angle = cameras.zoom(camera, view(cameras, camera)).viewingAngle();
    return new Sector(pose.x(), pose.y(), pose.heading(), angle, cameras.range(camera));
  }

  private static int view(Cameras cameras, int camera) {
    int seeing = cameras.seeing(camera);
    return seeing == Cameras.NO_VIEW ? cameras.view(camera) : seeing;
  }

  /** Whether the point lies inside. */
  boolean contains(double px, double py) {
    double dx = px - x;
    double dy = py - y;
    double squared = dx * dx + dy * dy;
    if (squared > radius * radius) {
      return false;
    }
    if (isCircle()) {
      return true;
    }
    double along = dx * Math.sin(heading) + dy * Math.cos(heading);
    return along >= Math.cos(angle / 2) * Math.sqrt(squared);
  }

  boolean isCircle() {
    return angle >= 2 * Math.PI;
  }

  /** The mathematical angle (0 is +x, anticlockwise) at which the arc starts. */
  double arcStart() {
    return Math.PI / 2 - heading - Math.min(angle, 2 * Math.PI) / 2;
  }
}
