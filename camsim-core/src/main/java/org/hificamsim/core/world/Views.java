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
 * Makes the views of a camera from its optics, the scenario's zoom list, or its range. Safe for use
 * by several threads.
 */
final class Views {
  /** The range, in metres, from which CamSim creates a camera with {@link #CLAMPED} instead. */
  private static final double MAX_RANGE = 20;

  private static final double CLAMPED = MAX_RANGE - MAX_RANGE * 0.2;

  /** All properties of a camera that its views depend on: {@link #make} may read no others. */
  private record CameraKind(
      double range, double viewingAngle, Optional<OpticsSpec> optics, VerticalView mounted) {}

  private final Scenario scenario;
  private final boolean flat;
  private final Map<CameraKind, ViewSet> viewsByKind = new ConcurrentHashMap<>();
  private final Map<ZoomLevel, Integer> numbers = new HashMap<>();

  Views(Scenario scenario) {
    this.scenario = scenario;
    this.flat = !scenario.hasHeights();
  }

  /** Returns the range with which CamSim creates a camera (behaviour 6.3). */
  static double clampedRange(double range) {
    return range >= MAX_RANGE ? CLAMPED : range;
  }

  /** Returns the views of a camera of the scenario; cameras of a kind share them. */
  ViewSet of(CameraSpec camera) {
    double range = camera.optics().isPresent() ? camera.range() : clampedRange(camera.range());
    return of(range, Math.toRadians(camera.viewingAngle()), camera);
  }

  /**
   * Returns the views of a camera that an event changed; cameras of a kind share them.
   *
   * @param range the range, in metres; ignored if the scenario has a zoom list
   * @param viewingAngle the viewing angle, in radians
   * @param camera gives all other properties
   */
  ViewSet of(double range, double viewingAngle, CameraSpec camera) {
    double ownRange = scenario.inCoverageDialect() ? 0 : range;
    double z = flat ? Double.NaN : scenario.z(camera);
    VerticalView mounted = new VerticalView(z, Math.toRadians(camera.tilt()), Double.NaN);
    return viewsByKind.computeIfAbsent(
        new CameraKind(ownRange, viewingAngle, camera.optics(), mounted), this::make);
  }

  /** Mounts a camera as the scenario describes it. */
  Mount mount(CameraSpec spec) {
    return mount(Pose.of(spec.x(), spec.y(), Math.toRadians(spec.heading())), of(spec));
  }

  /** Mounts a camera with these views. */
  Mount mount(Pose pose, ViewSet set) {
    return new Mount(pose, set, this::number);
  }

  /** Returns the number that equal zoom levels of all cameras share. */
  private synchronized int number(ZoomLevel zoom) {
    return numbers.computeIfAbsent(zoom, newZoom -> numbers.size());
  }

  private ViewSet make(CameraKind kind) {
    return kind.optics
        .map(optics -> make(kind, optics))
        .orElseGet(() -> ViewSet.of(round(kind, 0)));
  }

  /** Makes the views of optics. The reach of a lens is its own, or the diagonal of the field. */
  private ViewSet make(CameraKind kind, OpticsSpec optics) {
    return optics.law().hasAngles()
        ? ViewSet.ofLens(
            optics,
            Math.hypot(scenario.field().width(), scenario.field().height()),
            scenario.mountHeight().orElse(Double.NaN),
            kind.mounted)
        : ViewSet.of(optics, round(kind, optics.pixels().orElse(0)));
  }

  private List<ZoomLevel> round(CameraKind kind, int pixels) {
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
