package org.hificamsim.core.world;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.hificamsim.core.detection.VerticalView;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.hificamsim.core.visibility.Pose;

/**
 * Makes a camera's views from its optics, from a scenario's zoom list, or from its range alone. Any
 * number of threads may ask.
 */
final class Views {
  /** CamSim's constant: a camera created with this range or more gets {@link #CLAMPED} instead. */
  private static final double MAX_RANGE = 20;

  private static final double CLAMPED = MAX_RANGE - MAX_RANGE * 0.2;

  /** All that views depend on: what {@link #make} reads of a camera has to be here. */
  private record Kind(
      double range, double viewingAngle, Optional<OpticsSpec> optics, VerticalView mounted) {}

  private final Scenario scenario;
  private final boolean flat;
  private final Map<Kind, ViewSet> made = new ConcurrentHashMap<>();
  private final Map<ZoomLevel, Integer> numbers = new HashMap<>();

  Views(Scenario scenario) {
    this.scenario = scenario;
    this.flat = !scenario.hasHeights();
  }

  /** CamSim's rule for the range of a camera that is created (behaviour 6.3). */
  static double clampedRange(double range) {
    return range >= MAX_RANGE ? CLAMPED : range;
  }

  /** The views of a camera as the scenario gives it; cameras of a kind share them. */
  ViewSet of(CameraSpec camera) {
    double range = camera.optics().isPresent() ? camera.range() : clampedRange(camera.range());
    return of(range, Math.toRadians(camera.viewingAngle()), camera);
  }

  /**
   * The views of a camera that was changed; cameras of a kind share them.
   *
   * @param range used where the scenario has no zoom list, metres
   * @param viewingAngle radians
   * @param camera whose the rest is
   */
  ViewSet of(double range, double viewingAngle, CameraSpec camera) {
    double own = scenario.inCoverageDialect() ? 0 : range;
    double z = flat ? Double.NaN : scenario.z(camera);
    VerticalView mounted = new VerticalView(z, Math.toRadians(camera.tilt()), Double.NaN);
    return made.computeIfAbsent(new Kind(own, viewingAngle, camera.optics(), mounted), this::make);
  }

  /** How a camera is mounted as the scenario gives it. */
  Mount mount(CameraSpec spec) {
    return mount(Pose.of(spec.x(), spec.y(), Math.toRadians(spec.heading())), of(spec));
  }

  /** A camera with these views. */
  Mount mount(Pose pose, ViewSet set) {
    return new Mount(pose, set, this::number);
  }

  /** Equal zoom levels have one number, whichever cameras have them. */
  private synchronized int number(ZoomLevel zoom) {
    return numbers.computeIfAbsent(zoom, any -> numbers.size());
  }

  private ViewSet make(Kind kind) {
    return kind.optics
        .map(optics -> make(kind, optics))
        .orElseGet(() -> ViewSet.of(round(kind, 0)));
  }

  /** A lens without a reach of its own has the whole field in reach. */
  private ViewSet make(Kind kind, OpticsSpec optics) {
    return optics.law().hasAngles()
        ? ViewSet.ofLens(
            optics,
            Math.hypot(scenario.field().width(), scenario.field().height()),
            scenario.mountHeight().orElse(Double.NaN),
            kind.mounted)
        : ViewSet.of(optics, round(kind, optics.pixels().orElse(0)));
  }

  private List<ZoomLevel> round(Kind kind, int pixels) {
    List<Double> radii = scenario.inCoverageDialect() ? scenario.zooms() : List.of(kind.range);
    double narrowest = radii.get(0);
    double widest = radii.get(radii.size() - 1);
    double height = scenario.mountHeight().orElse(Double.NaN);
    return radii.stream()
        .map(
            radius ->
                new ZoomLevel(
                    radius,
                    narrowest,
                    widest,
                    height,
                    kind.viewingAngle,
                    Double.NaN,
                    pixels,
                    kind.mounted))
        .toList();
  }
}
