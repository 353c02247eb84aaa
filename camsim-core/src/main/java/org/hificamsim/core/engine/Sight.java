package org.hificamsim.core.engine;

import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.world.World;

/**
 * What cameras can see, where everything is now: a short pipeline of tests (reach, angle,
 * confidence).
 */
interface Sight {
  /** Chooses the cheapest sight that is exact for the detection model. */
  static Sight of(World world, Detection detection) {
    return detection.model().dependsOnBearing()
        ? new BearingSight(world, detection)
        : new DistanceSight(world, detection);
  }

  /** Takes note of cameras that changed since the last call. */
  void refresh();

  /** Whether the camera would detect the target, were it at this level. */
  boolean detects(int camera, int level, int target);

  /** Whether {@code level} is proven to detect whatever {@code other} does. */
  boolean dominates(int camera, int level, int other);
}
