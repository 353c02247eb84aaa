package org.hificamsim.bridge.run;

import java.util.List;
import org.hificamsim.core.detection.ZoomLevel;

/**
 * The zoom levels of CamSim's cameras, which have a range and nothing else.
 *
 * <p>A camera that a policy steers has the given radii, or {@value #LEVELS} of its own: evenly
 * spaced from a third of its range to its range, as in the thesis's scenarios (2.5 to 7.5 m). Any
 * other camera has one level, its range; given radii then only say how far its lens zooms.
 *
 * @param steered whether a policy sets the ranges
 * @param given radii, metres, rising; may be empty
 */
record Zooms(boolean steered, List<Double> given) {
  private static final int LEVELS = 5;
  private static final int STEPS_BELOW = 2;

  /** The number of levels, the same for all cameras. */
  int levels() {
    return !steered ? 1 : given.isEmpty() ? LEVELS : given.size();
  }

  /**
   * A camera's levels, the narrowest first.
   *
   * @param range metres
   * @param viewingAngle radians
   */
  ZoomLevel[] of(double range, double viewingAngle) {
    ZoomLevel[] levels = new ZoomLevel[levels()];
    for (int level = 0; level < levels.length; level++) {
      levels[level] =
          new ZoomLevel(
              radius(level, range),
              given.isEmpty() ? radius(0, range) : given.get(0),
              given.isEmpty() ? range : given.get(given.size() - 1),
              Double.NaN,
              viewingAngle);
    }
    return levels;
  }

  private double radius(int level, double range) {
    if (steered && !given.isEmpty()) {
      return given.get(level);
    }
    boolean widest = level == levels() - 1;
    return widest ? range : range * (level + STEPS_BELOW) / (LEVELS - 1 + STEPS_BELOW);
  }
}
