package org.hificamsim.runs.benchmark;

import java.util.function.UnaryOperator;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.CameraSpec;
import org.hificamsim.core.scenario.Field;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.TargetSpec;
import org.hificamsim.core.scenario.Waypoint;

/**
 * A site seen in a mirror.
 *
 * @param east whether east and west change places
 * @param north whether north and south do
 */
record Mirror(Field field, boolean east, boolean north) {
  Scenario of(Scenario site) {
    return site.with(
            Scenario.OBSTACLES,
            site.obstacles().stream().map(one -> moved(one, 1, this::of)).toList())
        .withCameras(this::of)
        .withTargets(this::of);
  }

  Waypoint of(Waypoint place) {
    return new Waypoint(
        east ? field.minX() + field.maxX() - place.x() : place.x(),
        north ? field.minY() + field.maxY() - place.y() : place.y());
  }

  private double heading(double degrees) {
    double turned = north ? 180 - degrees : degrees;
    return east ? -turned : turned;
  }

  private CameraSpec of(CameraSpec camera) {
    Waypoint place = of(new Waypoint(camera.x(), camera.y()));
    return camera
        .with(CameraSpec.X, place.x())
        .with(CameraSpec.Y, place.y())
        .with(CameraSpec.HEADING, heading(camera.heading()));
  }

  private TargetSpec of(TargetSpec target) {
    Waypoint place = of(new Waypoint(target.x(), target.y()));
    return target
        .with(TargetSpec.X, place.x())
        .with(TargetSpec.Y, place.y())
        .with(TargetSpec.HEADING, heading(target.heading()))
        .with(TargetSpec.WAYPOINTS, target.waypoints().stream().map(this::of).toList());
  }

  /** An obstacle whose points are moved, and of whose radius a part is left. */
  static Obstacle moved(Obstacle obstacle, double part, UnaryOperator<Waypoint> move) {
    if (obstacle instanceof Obstacle.Pillar one) {
      Waypoint to = move.apply(new Waypoint(one.x(), one.y()));
      return new Obstacle.Pillar(
          to.x(), to.y(), part * one.radius(), one.transmittance(), one.base(), one.height());
    }
    if (obstacle instanceof Obstacle.Wall one) {
      Waypoint from = move.apply(new Waypoint(one.x1(), one.y1()));
      Waypoint to = move.apply(new Waypoint(one.x2(), one.y2()));
      return new Obstacle.Wall(
          from.x(), from.y(), to.x(), to.y(), one.transmittance(), one.base(), one.height());
    }
    Obstacle.Polygon one = (Obstacle.Polygon) obstacle;
    return new Obstacle.Polygon(
        one.points().stream()
            .map(point -> move.apply(new Waypoint(point.x(), point.y())))
            .map(to -> new Point(to.x(), to.y()))
            .toList(),
        one.transmittance(),
        one.base(),
        one.height());
  }
}
