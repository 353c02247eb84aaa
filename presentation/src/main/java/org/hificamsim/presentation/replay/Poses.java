package org.hificamsim.presentation.replay;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.IntFunction;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.hificamsim.core.detection.DetectedDistances;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.OnAxis;
import org.hificamsim.core.detection.VerticalView;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.visibility.Footprint;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.presentation.replay.CameraPose.Interval;
import org.hificamsim.presentation.replay.CameraPose.Level;
import org.hificamsim.presentation.replay.CameraPose.LevelOptics;

/**
 * Makes the poses of cameras: what each sees from where it is, and at which distances it detects
 * targets of one size; along the heading where the model depends on the bearing.
 */
final class Poses {
  private final Detection detection;
  private final double size;
  private final Map<ZoomLevel, Level> levels = new HashMap<>();
  private final Outlook outlook;

  /**
   * @param size of the target whose detected ranges are shown, metres
   */
  Poses(Detection detection, double size, List<Obstacle> obstacles, Field field) {
    this.detection = new Detection(new OnAxis(detection.model()), detection.threshold());
    this.size = size;
    this.outlook = new Outlook(obstacles, field);
  }

  /** A camera at the start; one that is yet to be added stands where the scenario says. */
  CameraPose of(Cameras cameras, int camera, CameraSpec spec) {
    return pose(
        new Point(spec.x(), spec.y()),
        Math.toRadians(spec.heading()),
        cameras.zooms(camera),
        cameras.views(camera),
        view -> cameras.pan(camera, view),
        view -> cameras.zoom(camera, view),
        Optional.empty());
  }

  /** A camera that is online, which was in another pose before. */
  CameraPose of(NetworkView network, int camera, CameraPose before) {
    return pose(
        new Point(network.cameraX(camera), network.cameraY(camera)),
        network.cameraHeading(camera),
        network.zooms(camera),
        network.views(camera),
        view -> network.pan(camera, view),
        view -> network.zoom(camera, view),
        Optional.of(before));
  }

  /** Views are the zoom levels at the first pan angle, then at the next one. */
  private CameraPose pose(
      Point at,
      double heading,
      int levelCount,
      int views,
      IntToDoubleFunction pan,
      IntFunction<ZoomLevel> zoom,
      Optional<CameraPose> before) {
    List<ZoomLevel> zooms = IntStream.range(0, levelCount).mapToObj(zoom).toList();
    List<ZoomLevel> turned =
        IntStream.range(0, views / levelCount).mapToObj(i -> zoom.apply(i * levelCount)).toList();
    List<Double> pans =
        IntStream.range(0, turned.size()).mapToObj(i -> pan.applyAsDouble(i * levelCount)).toList();
    List<Double> tilts = turned.stream().map(level -> level.vertical().tilt()).toList();
    List<LevelOptics> lenses = zooms.stream().map(LevelOptics::of).toList();
    boolean alike = lenses.stream().distinct().count() == 1 && lenses.get(0).density() == 0;
    List<Level> detecting = levels(zooms);
    return new CameraPose(
        at.x(),
        at.y(),
        heading,
        zooms.get(0).viewingAngle(),
        detecting,
        pans.equals(List.of(0.0)) ? List.of() : pans,
        Set.copyOf(tilts).size() == 1 ? List.of() : tilts,
        alike ? List.of() : lenses,
        before
            .filter(was -> at.x() == was.x() && at.y() == was.y())
            .filter(was -> detecting.equals(was.levels()))
            .map(CameraPose::visible)
            .orElseGet(
                () -> outlook.from(at.x(), at.y(), zooms.get(0).vertical().z(), reach(detecting))),
        grounds(views, zoom));
  }

  /** The levels of the first pan angle, at each tilt; those of the others are the same. */
  private List<List<Double>> grounds(int views, IntFunction<ZoomLevel> zoom) {
    return IntStream.range(0, views)
        .mapToObj(zoom)
        .filter(level -> !Double.isNaN(level.vertical().angle()))
        .distinct()
        .map(
            level ->
                Footprint.of(level, 0, 0).corners(farthest(level)).stream()
                    .flatMap(corner -> Stream.of(corner.x(), corner.y()))
                    .toList())
        .toList();
  }

  private static double reach(List<Level> levels) {
    return levels.stream().mapToDouble(Level::radius).max().orElse(0);
  }

  private List<Level> levels(List<ZoomLevel> zooms) {
    return zooms.stream().map(zoom -> levels.computeIfAbsent(zoom, this::detecting)).toList();
  }

  private double farthest(ZoomLevel zoom) {
    Level level = levels.computeIfAbsent(zoom, this::detecting);
    return level.detected().stream().mapToDouble(Interval::to).max().orElse(level.radius());
  }

  private Level detecting(ZoomLevel zoom) {
    VerticalView vertical = zoom.vertical();
    Detection onGround = vertical.flat() ? detection : detection.inSpace(vertical.z(), false);
    DetectedDistances distances = onGround.distances(size, zoom);
    List<Interval> intervals =
        IntStream.range(0, distances.intervals())
            .mapToObj(i -> new Interval(Math.sqrt(distances.from(i)), Math.sqrt(distances.to(i))))
            .toList();
    return new Level(zoom.radius(), intervals);
  }
}
