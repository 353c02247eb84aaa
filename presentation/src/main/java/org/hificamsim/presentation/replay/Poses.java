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
 * Computes the poses of cameras: what each sees from where it is, and the distances at which it
 * detects targets of one size. If the model depends on the bearing, these are along the heading.
 */
final class Poses {
  private final Detection detection;
  private final double targetSize;
  private final Map<ZoomLevel, Level> levels = new HashMap<>();
  private final Outlook outlook;

  /**
   * The views of a camera: its zoom levels at the first pan angle, then at the next one.
   *
   * @param levels the number of zoom levels
   * @param count the number of views
   * @param pan the pan angle by view, in radians
   * @param zoom the zoom by view
   */
  private record CameraViews(
      int levels, int count, IntToDoubleFunction pan, IntFunction<ZoomLevel> zoom) {
    /** The levels at the first pan angle. */
    List<ZoomLevel> firstDirection() {
      return IntStream.range(0, levels).mapToObj(zoom).toList();
    }

    /** The narrowest level at each pan angle. */
    List<ZoomLevel> narrowest() {
      return IntStream.range(0, count / levels).mapToObj(i -> zoom.apply(i * levels)).toList();
    }

    List<Double> pans() {
      return IntStream.range(0, count / levels)
          .mapToObj(i -> pan.applyAsDouble(i * levels))
          .toList();
    }
  }

  /**
   * @param targetSize the size of targets for which distances are shown, in metres
   */
  Poses(Detection detection, double targetSize, List<Obstacle> obstacles, Field field) {
    this.detection = new Detection(new OnAxis(detection.model()), detection.threshold());
    this.targetSize = targetSize;
    this.outlook = new Outlook(obstacles, field);
  }

  /** Returns the pose of a camera at the start, or where an event will add it. */
  CameraPose of(Cameras cameras, int camera, CameraSpec spec) {
    return pose(
        new Point(spec.x(), spec.y()),
        Math.toRadians(spec.heading()),
        new CameraViews(
            cameras.zooms(camera),
            cameras.views(camera),
            view -> cameras.pan(camera, view),
            view -> cameras.zoom(camera, view)),
        null);
  }

  /**
   * Returns the pose of a camera that is online.
   *
   * @param before the last known pose of the camera
   */
  CameraPose of(NetworkView network, int camera, CameraPose before) {
    return pose(
        new Point(network.cameraX(camera), network.cameraY(camera)),
        network.cameraHeading(camera),
        new CameraViews(
            network.zooms(camera),
            network.views(camera),
            view -> network.pan(camera, view),
            view -> network.zoom(camera, view)),
        before);
  }

  private CameraPose pose(Point place, double heading, CameraViews views, CameraPose before) {
    List<ZoomLevel> zooms = views.firstDirection();
    List<Double> pans = views.pans();
    List<Double> tilts = views.narrowest().stream().map(zoom -> zoom.vertical().tilt()).toList();
    List<LevelOptics> lenses = zooms.stream().map(LevelOptics::of).toList();
    boolean sameLens = lenses.stream().distinct().count() == 1 && lenses.get(0).density() == 0;
    List<Level> poseLevels = levels(zooms);
    boolean sameVisible =
        before != null
            && place.x() == before.x()
            && place.y() == before.y()
            && poseLevels.equals(before.levels());
    return new CameraPose(
        place.x(),
        place.y(),
        heading,
        zooms.get(0).viewingAngle(),
        poseLevels,
        pans.equals(List.of(0.0)) ? List.of() : pans,
        Set.copyOf(tilts).size() == 1 ? List.of() : tilts,
        sameLens ? List.of() : lenses,
        sameVisible
            ? before.visible()
            : outlook.from(place.x(), place.y(), zooms.get(0).vertical().z(), reach(poseLevels)),
        grounds(views));
  }

  /** Returns the grounds of all levels; levels at the same tilt have the same ground. */
  private List<List<Double>> grounds(CameraViews views) {
    return IntStream.range(0, views.count())
        .mapToObj(views.zoom())
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
    return zooms.stream().map(zoom -> levels.computeIfAbsent(zoom, this::levelOf)).toList();
  }

  private double farthest(ZoomLevel zoom) {
    Level level = levels.computeIfAbsent(zoom, this::levelOf);
    return level.detected().stream().mapToDouble(Interval::to).max().orElse(level.radius());
  }

  private Level levelOf(ZoomLevel zoom) {
    VerticalView vertical = zoom.vertical();
    Detection onGround = vertical.flat() ? detection : detection.inSpace(vertical.z(), false);
    DetectedDistances distances = onGround.distances(targetSize, zoom);
    List<Interval> intervals =
        IntStream.range(0, distances.intervals())
            .mapToObj(i -> new Interval(Math.sqrt(distances.from(i)), Math.sqrt(distances.to(i))))
            .toList();
    return new Level(zoom.radius(), intervals);
  }
}
