package org.hificamsim.bridge.run;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.hificamsim.core.world.ViewSet;

/**
 * Computes the views of CamSim's cameras.
 *
 * <p>A camera that a policy steers has the views of the given optics; without optics, those with
 * the given radii; without radii, {@value #LEVELS} levels of its own. These are evenly spaced from
 * a third of its range to its range, as in the scenarios of the thesis (2.5 to 7.5 m). Any other
 * camera has one level, its range; given radii then only limit the zoom of its lens.
 *
 * @param steered whether a policy chooses among the views
 * @param radii the radii in metres, rising; may be empty
 * @param optics the optics, whose reach is the range of each camera
 */
record CameraViews(boolean steered, List<Double> radii, Optional<OpticsSpec> optics) {
  private static final int LEVELS = 5;
  private static final int STEPS_BELOW = 2;

  /**
   * Returns the views of a camera; their number is the same for all cameras.
   *
   * @param range the range of the camera, in metres
   * @param viewingAngle the full opening angle of the camera, in radians
   */
  ViewSet of(double range, double viewingAngle) {
    return optics
        .map(lens -> ViewSet.ofLens(lens, range, Double.NaN))
        .orElseGet(() -> ViewSet.of(zooms(range, viewingAngle)));
  }

  private List<ZoomLevel> zooms(double range, double viewingAngle) {
    return IntStream.range(0, levels())
        .mapToObj(
            level ->
                new ZoomLevel(
                    radius(level, range),
                    radii.isEmpty() ? radius(0, range) : radii.get(0),
                    radii.isEmpty() ? range : radii.get(radii.size() - 1),
                    Double.NaN,
                    viewingAngle))
        .toList();
  }

  private int levels() {
    return !steered ? 1 : radii.isEmpty() ? LEVELS : radii.size();
  }

  private double radius(int level, double range) {
    if (steered && !radii.isEmpty()) {
      return radii.get(level);
    }
    boolean widest = level == levels() - 1;
    return widest ? range : range * (level + STEPS_BELOW) / (LEVELS - 1 + STEPS_BELOW);
  }
}
