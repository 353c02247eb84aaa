package org.hificamsim.core.engine;

import org.hificamsim.core.space.PointGrid;
import org.hificamsim.core.visibility.Visibility;
import org.hificamsim.core.world.World;

/**
 * What cameras can see, where everything is now: the pipeline of {@link Visibility}, asked of many
 * targets at a time. Between two refreshes any number of threads may ask.
 */
interface Sight {
  /** Chooses the fastest sight that is exact for the detection model. */
  static Sight of(World world, Visibility visibility) {
    if (visibility.detection().model().dependsOnBearing()) {
      return new BearingSight(world, visibility);
    }
    return visibility.detection().certain()
        ? new DistanceSight(world, visibility)
        : new ChanceSight(world, visibility);
  }

  /**
   * Takes note of cameras that changed since the last call.
   *
   * @param step that begins
   */
  void refresh(long step);

  /** Whether the camera would detect the target, were it at this view. */
  boolean detects(int camera, int view, int target);

  /** The same, were it turned so that its picture has the target. */
  boolean detectsTurned(int camera, int view, int target);

  /** The chance that the camera detects the target, were it at this view, in [0, 1]. */
  default double chance(int camera, int view, int target) {
    return detects(camera, view, target) ? 1 : 0;
  }

  /**
   * The model's value for a target that the camera detects at this view, as it would be with
   * nothing in between; to about 1e-8.
   *
   * @param distance between the two, metres
   */
  double value(int camera, int view, int target, double distance);

  /** Whether {@code view} is proven to detect whatever {@code other} does. */
  boolean dominates(int camera, int view, int other);

  /** The distance beyond which the camera detects nothing at this view, metres; rounded up. */
  double reach(int camera, int view);

  /**
   * Counts the targets that the camera would detect at this view, among some that are near.
   *
   * @param grid where they are; those from index {@code from} up to {@code to} are looked at
   * @param counts one is added to the entry of each index whose target is detected
   */
  default int look(int camera, int view, PointGrid grid, int from, int to, int[] counts) {
    int count = 0;
    for (int i = from; i < to; i++) {
      if (detects(camera, view, grid.point(i))) {
        counts[i]++;
        count++;
      }
    }
    return count;
  }

  /**
   * Looks with some cameras, each through the view that it sees through, at all targets: faster
   * than {@link #look} camera by camera, where there is a way.
   *
   * @param grid of one cell
   * @param detected receives how many targets each of the cameras detects; 0 for one that is off
   * @param counts as of {@link #look}
   * @return whether there is; else nothing was done
   */
  default boolean lookAll(int from, int to, PointGrid grid, int[] detected, int[] counts) {
    return false;
  }

  /**
   * Finds the targets that the camera would detect at this view, among some that are near.
   *
   * @param grid where they are; those from index {@code from} up to {@code to} are looked at
   * @param found receives those that are detected, from entry {@code count} on: the camera in the
   *     upper half, the index in the lower
   * @return how many entries are filled then; the next one may be written too
   */
  default int find(
      int camera, int view, PointGrid grid, int from, int to, long[] found, int count) {
    long first = (long) camera << Integer.SIZE;
    int filled = count;
    for (int i = from; i < to; i++) {
      if (detects(camera, view, grid.point(i))) {
        found[filled++] = first + i;
      }
    }
    return filled;
  }

  /**
   * Finds what all cameras detect of all targets, as {@link #lookAll} looks.
   *
   * @param found as of {@link #find}, from entry 0 on; with room for all pairs and one more
   * @return how many entries are filled, or -1 where there is no such way
   */
  default int findAll(PointGrid grid, long[] found) {
    return -1;
  }

  /**
   * Marks the targets that the camera would detect at each of its views, among some that are near.
   *
   * @param masks as {@link org.hificamsim.core.policy.OracleView#detections} has them
   */
  void mark(int camera, int views, PointGrid grid, int from, int to, long[] masks, int words);
}
