package org.hificamsim.presentation.replay;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
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
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.scenario.CameraSpec;
import org.hificamsim.core.scenario.Field;
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
    List<ZoomLevel> zooms = zooms(cameras.zooms(camera), level -> cameras.zoom(camera, level));
    List<Level> detecting = levels(zooms);
    return pose(
        spec.x(),
        spec.y(),
        Math.toRadians(spec.heading()),
        zooms,
        pans(cameras.views(camera), zooms.size(), view -> cameras.pan(camera, view)),
        tilts(cameras.views(camera), zooms.size(), view -> cameras.zoom(camera, view)),
        outlook.from(spec.x(), spec.y(), zooms.get(0).vertical().z(), reach(detecting)),
        grounds(cameras.views(camera), view -> cameras.zoom(camera, view)));
  }

  /** A camera that is online, which was in another pose before. */
  CameraPose of(NetworkView network, int camera, CameraPose before) {
    double x = network.cameraX(camera);
    double y = network.cameraY(camera);
    List<ZoomLevel> zooms = zooms(network.zooms(camera), level -> network.zoom(camera, level));
    List<Level> detecting = levels(zooms);
    boolean asBefore = x == before.x() && y == before.y() && detecting.equals(before.levels());
    return pose(
        x,
        y,
        network.cameraHeading(camera),
        zooms,
        pans(network.views(camera), zooms.size(), view -> network.pan(camera, view)),
        tilts(network.views(camera), zooms.size(), view -> network.zoom(camera, view)),
        asBefore
            ? before.visible()
            : outlook.from(x, y, zooms.get(0).vertical().z(), reach(detecting)),
        grounds(network.views(camera), view -> network.zoom(camera, view)));
  }

  private static List<ZoomLevel> zooms(int count, IntFunction<ZoomLevel> zoom) {
    return IntStream.range(0, count).mapToObj(zoom).toList();
  }

  private static List<Double> pans(int views, int zooms, IntToDoubleFunction pan) {
    List<Double> pans =
        IntStream.range(0, views / zooms).mapToObj(i -> pan.applyAsDouble(i * zooms)).toList();
    return pans.equals(List.of(0.0)) ? List.of() : pans;
  }

  private static List<Double> tilts(int views, int zooms, IntFunction<ZoomLevel> zoom) {
    List<Double> tilts =
        IntStream.range(0, views / zooms)
            .mapToObj(i -> zoom.apply(i * zooms).vertical().tilt())
            .toList();
    return Set.copyOf(tilts).size() == 1 ? List.of() : tilts;
  }

  private CameraPose pose(
      double x,
      double y,
      double heading,
      List<ZoomLevel> zooms,
      List<Double> pans,
      List<Double> tilts,
      List<Double> visible,
      List<List<Double>> grounds) {
    List<LevelOptics> lenses = zooms.stream().map(LevelOptics::of).toList();
    boolean alike = lenses.stream().distinct().count() == 1 && lenses.get(0).density() == 0;
    return new CameraPose(
        x,
        y,
        heading,
        zooms.get(0).viewingAngle(),
        levels(zooms),
        pans,
        tilts,
        alike ? List.of() : lenses,
        visible,
        grounds);
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
