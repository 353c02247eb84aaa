package org.hificamsim.network.statistics;

import org.hificamsim.core.visibility.Pose;
import org.hificamsim.core.world.Cameras;

/**
 * The circle around a camera within its current range; CamSim ignores opening angles.
 *
 * @param x the x coordinate in metres
 * @param y the y coordinate in metres
 * @param radius the radius in metres; 0 while the camera moves blindly
 */
record RangeCircle(double x, double y, double radius) {
  /** Returns the circle of a camera as it is now. */
  static RangeCircle of(Cameras cameras, int camera) {
    Pose pose = cameras.pose(camera);
    return new RangeCircle(pose.x(), pose.y(), cameras.range(camera));
  }
}
