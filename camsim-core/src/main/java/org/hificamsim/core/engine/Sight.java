package org.hificamsim.core.engine;

import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.space.PointGrid;
import org.hificamsim.core.world.World;

/**
 * What cameras can see, where everything is now: a short pipeline of tests (reach, angle,
 * confidence). Between two refreshes any number of threads may ask.
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

  /** The distance beyond which the camera detects nothing at this level, metres; rounded up. */
  double reach(int camera, int level);

  /**
   * Counts the targets that the camera would detect at this level, among some that are near.
   *
   * @param targets where they are; those from index {@code from} up to {@code to} are looked at
   * @param counts one is added to the entry of each index whose target is detected
   */
  default int look(int camera, int level, PointGrid targets, int from, int to, int[] counts) {
    int count = 0;
    for (int i = from; i < to; i++) {
      if (detects(camera, level, targets.point(i))) {
        counts[i]++;
        count++;
      }
    }
    return count;
  }

  /**
   * Marks the targets that the camera would detect at each of its levels, among some that are near.
   *
   * @param masks as {@link org.hificamsim.core.policy.NetworkView#detections} has them
   */
  default void mark(
      int camera, int levels, PointGrid targets, int from, int to, long[] masks, int words) {
    for (int i = from; i < to; i++) {
      int target = targets.point(i);
      for (int level = 0; level < levels; level++) {
        if (detects(camera, level, target)) {
          masks[level * words + (target >> 6)] |= 1L << target;
        }
      }
    }
  }
}
