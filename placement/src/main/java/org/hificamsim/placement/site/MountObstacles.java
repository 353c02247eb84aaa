package org.hificamsim.placement.site;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.Zone;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Envelope;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.operation.distance.IndexedFacetDistance;

/**
 * The obstacles that matter to mounting cameras: those that a site has at the height of its
 * cameras, and the border of the field.
 */
final class MountObstacles {
  /** A distance above the error of points that are rounded to centimetres, in metres. */
  private static final double ROUNDING = 0.008;

  private static final GeometryFactory GEOMETRY = new GeometryFactory();

  private final List<Obstacle> list;
  private final Obstacles cutAtHeight;
  private final List<Geometry> shapes;
  private final IndexedFacetDistance surfaces;

  MountObstacles(Scenario site) {
    OptionalDouble height = Mounting.heightOn(site);
    list =
        site.obstacles().stream()
            .filter(obstacle -> height.isEmpty() || reaches(obstacle, height.getAsDouble()))
            .toList();
    cutAtHeight = new Obstacles(list.stream().map(Obstacle::flat).toList());
    shapes = list.stream().map(MountObstacles::shape).toList();
    surfaces =
        new IndexedFacetDistance(
            GEOMETRY.createGeometryCollection(
                Stream.concat(Stream.of(border(site.field())), shapes.stream())
                    .toArray(Geometry[]::new)));
  }

  private static boolean reaches(Obstacle obstacle, double height) {
    return obstacle.base() <= height && obstacle.height() >= height;
  }

  private static Geometry border(Field field) {
    return GEOMETRY
        .toGeometry(new Envelope(field.minX(), field.maxX(), field.minY(), field.maxY()))
        .getBoundary();
  }

  private static Geometry shape(Obstacle obstacle) {
    if (obstacle instanceof Obstacle.Wall wall) {
      return line(new Point(wall.x1(), wall.y1()), new Point(wall.x2(), wall.y2()));
    }
    if (obstacle instanceof Obstacle.Polygon polygon) {
      List<Point> corners = polygon.points();
      return GEOMETRY.createPolygon(
          IntStream.rangeClosed(0, corners.size())
              .mapToObj(i -> coordinate(corners.get(i % corners.size())))
              .toArray(Coordinate[]::new));
    }
    Obstacle.Pillar pillar = (Obstacle.Pillar) obstacle;
    return GEOMETRY.createPoint(new Coordinate(pillar.x(), pillar.y())).buffer(pillar.radius(), 32);
  }

  private static Geometry line(Point from, Point to) {
    return GEOMETRY.createLineString(new Coordinate[] {coordinate(from), coordinate(to)});
  }

  private static Coordinate coordinate(Point point) {
    return new Coordinate(point.x(), point.y());
  }

  /** Returns the building that the obstacles enclose, if all zones are inside it. */
  Optional<Enclosure> enclosure(List<Zone> zones) {
    return Enclosure.of(shapes, zones);
  }

  /** The obstacles, in the order of the site. */
  List<Obstacle> list() {
    return list;
  }

  /**
   * Whether a point is in no obstacle and far enough from all of them to mount a camera there.
   *
   * @param point the point with coordinates that are rounded to centimetres
   * @param clearance the least distance from obstacles and border, in metres
   */
  boolean isFree(Point point, double clearance) {
    return cutAtHeight.containing(point.x(), point.y()).isEmpty()
        && surfaces.distance(GEOMETRY.createPoint(coordinate(point))) >= clearance - ROUNDING;
  }

  /** Whether an obstacle or the border is between two points. */
  boolean isBetween(Point from, Point to) {
    return surfaces.distance(line(from, to)) == 0;
  }
}
