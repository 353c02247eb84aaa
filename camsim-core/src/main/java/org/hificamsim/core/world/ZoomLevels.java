package org.hificamsim.core.world;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.scenario.CameraSpec;
import org.hificamsim.core.scenario.Scenario;

/** Makes a camera's zoom levels from a scenario's zoom list, or from the camera's range alone. */
final class ZoomLevels {
  /** CamSim's constant: a camera created with this range or more gets {@link #CLAMPED} instead. */
  private static final double MAX_RANGE = 20;

  private static final double CLAMPED = MAX_RANGE - MAX_RANGE * 0.2;

  private record Kind(double range, double viewingAngle) {}

  private final Scenario scenario;
  private final Map<Kind, ZoomLevel[]> made = new HashMap<>();

  ZoomLevels(Scenario scenario) {
    this.scenario = scenario;
  }

  /** CamSim's rule for the range of a camera that is created (behaviour 6.3). */
  static double clampedRange(double range) {
    return range >= MAX_RANGE ? CLAMPED : range;
  }

  /** The levels of a camera as the scenario gives it; cameras of a kind share them. */
  ZoomLevel[] of(CameraSpec camera) {
    return of(clampedRange(camera.range()), Math.toRadians(camera.viewingAngle()));
  }

  /**
   * The levels of a camera; cameras of a kind share them.
   *
   * @param range used where the scenario has no zoom list, metres
   * @param viewingAngle radians
   */
  ZoomLevel[] of(double range, double viewingAngle) {
    double own = scenario.inCoverageDialect() ? 0 : range;
    return made.computeIfAbsent(new Kind(own, viewingAngle), this::make);
  }

  private ZoomLevel[] make(Kind kind) {
    List<Double> radii = scenario.inCoverageDialect() ? scenario.zooms() : List.of(kind.range);
    double narrowest = radii.get(0);
    double widest = radii.get(radii.size() - 1);
    double height = scenario.mountHeight().orElse(Double.NaN);
    return radii.stream()
        .map(radius -> new ZoomLevel(radius, narrowest, widest, height, kind.viewingAngle))
        .toArray(ZoomLevel[]::new);
  }
}
