package org.hificamsim.core.policy;

import java.util.Arrays;
import org.hificamsim.core.metrics.CoverableTargets;
import org.hificamsim.core.metrics.DetectionChances;

/**
 * A camera network with knowledge that no camera has: where the targets are, and what cameras would
 * detect at other views. {@linkplain OraclePolicy Bounds} such as the exact optimum are given it,
 * and listeners that record a run.
 *
 * <p>An implementer writes the positions of targets and {@link #detects}, {@link #dominates} and
 * {@link #certain}; what cameras see follows from these.
 */
public interface OracleView extends NetworkView, DetectionChances, CoverableTargets {
  /** The x coordinate of a target, in metres. */
  double targetX(int target);

  /** The y coordinate of a target, in metres. */
  double targetY(int target);

  /**
   * The present angle of the camera's head, even on its way: radians off its heading, to the right.
   */
  default double presentPan(int camera) {
    return pan(camera, view(camera));
  }

  /** The present zoom level of the camera's lens, which is no whole number on its way. */
  default double presentZoom(int camera) {
    return zoomOf(camera, view(camera));
  }

  /** Whether the camera would detect the target where both are now, were it at this view. */
  boolean detects(int camera, int view, int target);

  @Override
  default boolean sees(int camera, int target) {
    int view = seeing(camera);
    return online(camera) && view >= 0 && present(target) && detects(camera, view, target);
  }

  @Override
  default double distance(int camera, int target) {
    return sees(camera, target)
        ? Math.hypot(targetX(target) - cameraX(camera), targetY(target) - cameraY(camera))
        : Double.NaN;
  }

  @Override
  default double bearing(int camera, int target) {
    if (!sees(camera, target)) {
      return Double.NaN;
    }
    double axis = cameraHeading(camera) + pan(camera, seeing(camera));
    double direction =
        Math.atan2(targetX(target) - cameraX(camera), targetY(target) - cameraY(camera));
    return Math.IEEEremainder(direction - axis, 2 * Math.PI);
  }

  @Override
  default void findSeen(SeenPairs pairs) {
    pairs.clear();
    for (int camera = 0; camera < cameras(); camera++) {
      for (int target = 0; target < targets(); target++) {
        if (sees(camera, target)) {
          double distance = distance(camera, target);
          double bearing = bearing(camera, target);
          pairs.add(camera, target, distance * Math.cos(bearing), distance * Math.sin(bearing));
        }
      }
    }
  }

  @Override
  default void markCoverable(boolean[] coverable) {
    for (int target = 0; target < targets(); target++) {
      coverable[target] = false;
      for (int camera = 0; camera < cameras() && present(target); camera++) {
        for (int view = 0; online(camera) && view < views(camera) && !coverable[target]; view++) {
          coverable[target] = detects(camera, view, target);
        }
      }
    }
  }

  /** Whether no luck is drawn: each {@link #chance} is 1 or 0, as {@link #detects} says. */
  boolean certain();

  /**
   * The chance that the camera detects the target where both are now, were it at this view, before
   * luck is drawn: in [0, 1], 1 or 0 by a threshold.
   */
  default double chance(int camera, int view, int target) {
    return detects(camera, view, target) ? 1 : 0;
  }

  /**
   * The targets that the camera has a {@link #chance} above 0 to detect, were it at this view.
   *
   * @param targets as long as there are targets; filled from the start
   * @param chances one entry for each of them
   * @return the number of these targets
   */
  default int chances(int camera, int view, int[] targets, double[] chances) {
    int count = 0;
    for (int target = 0; target < targets(); target++) {
      double chance = present(target) ? chance(camera, view, target) : 0;
      chances[count] = chance;
      targets[count] = target;
      count += chance > 0 ? 1 : 0;
    }
    return count;
  }

  @Override
  default int chances(int camera, int[] targets, double[] chances) {
    int view = seeing(camera);
    return online(camera) && view >= 0 ? chances(camera, view, targets, chances) : 0;
  }

  /**
   * Whether {@code view} is proven to detect everything that {@code other} does, wherever the
   * targets stand; false if that is not known.
   */
  boolean dominates(int camera, int view, int other);

  /**
   * Computes what the camera would detect in each of its views at the present positions: {@link
   * #detects} for all targets at once.
   *
   * @param masks filled with {@code words} words for each view, view 0 first; target t is at bit
   *     {@code t % 64} of word {@code t / 64}
   * @param words the number of words of a view, enough for all targets
   */
  default void detections(int camera, long[] masks, int words) {
    Arrays.fill(masks, 0, views(camera) * words, 0);
    for (int view = 0; view < views(camera); view++) {
      for (int target = 0; target < targets(); target++) {
        if (present(target) && detects(camera, view, target)) {
          masks[view * words + (target >> 6)] |= 1L << target;
        }
      }
    }
  }
}
