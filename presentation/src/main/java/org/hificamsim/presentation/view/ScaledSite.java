package org.hificamsim.presentation.view;

import java.util.List;
import org.hificamsim.core.InputException;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Obstacle.Pillar;
import org.hificamsim.core.obstacle.Obstacle.Polygon;
import org.hificamsim.core.obstacle.Obstacle.Wall;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.Floorplan;
import org.hificamsim.core.scenario.spec.Zone;

/**
 * Makes a site larger or smaller on the ground, from the origin. Heights stay.
 *
 * @param factor above 0
 */
record ScaledSite(double factor) {
  private static final double MAX_FACTOR = 1e6;

  /**
   * Checks the factor.
   *
   * @throws InputException if it is not above 0, or too large or small
   */
  ScaledSite {
    if (!(factor >= 1 / MAX_FACTOR && factor <= MAX_FACTOR)) {
      throw InputException.of(
          "the scale changes by a factor of %s, expected one from %s to %s",
          factor, 1 / MAX_FACTOR, MAX_FACTOR);
    }
  }

  /**
   * Returns a site with all places scaled.
   *
   * @throws InputException if it has targets, whose speeds are in metres
   */
  Scenario of(Scenario site) {
    if (site.everyTarget().findAny().isPresent() || !site.events().isEmpty()) {
      throw new InputException("the site has targets or events, expected a plan alone to scale");
    }
    Scenario scaled =
        site.withField(scaled(site.field()))
            .with(Scenario.OBSTACLES, site.obstacles().stream().map(this::scaled).toList())
            .with(Scenario.ZONES, site.zones().stream().map(this::scaled).toList())
            .withCameras(
                camera ->
                    camera
                        .with(CameraSpec.X, scaled(camera.x()))
                        .with(CameraSpec.Y, scaled(camera.y())));
    return site.floorplan()
        .map(floor -> scaled.withFloorplan(new Floorplan(floor.file(), scaled(floor.area()))))
        .orElse(scaled);
  }

  /** Returns a scaled coordinate, rounded to a tenth of a millimetre. */
  private double scaled(double coordinate) {
    return Math.rint(coordinate * factor * 1e4) / 1e4;
  }

  private Field scaled(Field area) {
    return new Field(
        scaled(area.minX()), scaled(area.maxX()), scaled(area.minY()), scaled(area.maxY()));
  }

  private List<Point> scaled(List<Point> points) {
    return points.stream().map(point -> new Point(scaled(point.x()), scaled(point.y()))).toList();
  }

  private Zone scaled(Zone zone) {
    return zone.withPoints(scaled(zone.points()));
  }

  private Obstacle scaled(Obstacle obstacle) {
    Obstacle flat = scaledOnGround(obstacle);
    return flat.between(obstacle.base(), obstacle.height());
  }

  private Obstacle scaledOnGround(Obstacle obstacle) {
    if (obstacle instanceof Wall wall) {
      return new Wall(
          scaled(wall.x1()),
          scaled(wall.y1()),
          scaled(wall.x2()),
          scaled(wall.y2()),
          wall.transmittance());
    }
    if (obstacle instanceof Pillar pillar) {
      return new Pillar(
          scaled(pillar.x()), scaled(pillar.y()), scaled(pillar.radius()), pillar.transmittance());
    }
    return new Polygon(scaled(((Polygon) obstacle).points()), obstacle.transmittance());
  }
}
