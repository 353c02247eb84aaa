package org.hificamsim.presentation.replay;

import java.util.List;
import java.util.function.IntFunction;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.scenario.CameraSpec;
import org.hificamsim.core.scenario.Field;
import org.hificamsim.core.world.Cameras;

/** Makes the poses of cameras: what each sees from where it is. */
final class Poses {
  private final DetectedRanges ranges;
  private final Outlook outlook;

  /**
   * @param size of the target whose detected ranges are shown, metres
   */
  Poses(Detection detection, double size, List<Obstacle> obstacles, Field field) {
    this.ranges = new DetectedRanges(detection, size);
    this.outlook = new Outlook(obstacles, field);
  }

  /** A camera at the start; one that is yet to be added stands where the scenario says. */
  CameraPose of(Cameras cameras, int camera, CameraSpec spec) {
    Eye eye = eye(cameras, camera);
    List<Level> levels = ranges.levels(eye.zooms, eye.zoom);
    return eye.pose(
        spec.x(),
        spec.y(),
        Math.toRadians(spec.heading()),
        levels,
        outlook.from(spec.x(), spec.y(), reach(levels)));
  }

  /** A camera that is online, which was in another pose before. */
  CameraPose of(NetworkView network, int camera, CameraPose before) {
    double x = network.cameraX(camera);
    double y = network.cameraY(camera);
    Eye eye = eye(network, camera);
    List<Level> levels = ranges.levels(eye.zooms, eye.zoom);
    boolean asBefore = x == before.x() && y == before.y() && levels.equals(before.levels());
    return eye.pose(
        x,
        y,
        network.cameraHeading(camera),
        levels,
        asBefore ? before.visible() : outlook.from(x, y, reach(levels)));
  }

  private static double reach(List<Level> levels) {
    return levels.stream().mapToDouble(Level::radius).max().orElse(0);
  }

  private static Eye eye(Cameras of, int camera) {
    return new Eye(
        of.views(camera),
        of.zooms(camera),
        level -> of.zoom(camera, level),
        view -> of.pan(camera, view));
  }

  private static Eye eye(NetworkView of, int camera) {
    return new Eye(
        of.views(camera),
        of.zooms(camera),
        level -> of.zoom(camera, level),
        view -> of.pan(camera, view));
  }

  /** The views of a camera. */
  private record Eye(int views, int zooms, IntFunction<ZoomLevel> zoom, IntToDoubleFunction pan) {
    CameraPose pose(double x, double y, double heading, List<Level> levels, List<Double> visible) {
      return new CameraPose(
          x, y, heading, zoom.apply(0).viewingAngle(), levels, pans(), lenses(), visible);
    }

    private List<Double> pans() {
      List<Double> pans =
          IntStream.range(0, views / zooms).mapToObj(i -> pan.applyAsDouble(i * zooms)).toList();
      return pans.equals(List.of(0.0)) ? List.of() : pans;
    }

    private List<LevelOptics> lenses() {
      List<LevelOptics> lenses =
          IntStream.range(0, zooms).mapToObj(zoom).map(LevelOptics::of).toList();
      boolean alike = lenses.stream().distinct().count() == 1 && lenses.get(0).density() == 0;
      return alike ? List.of() : lenses;
    }
  }
}
