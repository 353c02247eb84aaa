package org.hificamsim.placement.site;

import java.util.List;
import java.util.Optional;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.spec.Zone;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.Polygon;
import org.locationtech.jts.geom.prep.PreparedGeometry;
import org.locationtech.jts.geom.prep.PreparedGeometryFactory;
import org.locationtech.jts.operation.union.UnaryUnionOp;

/**
 * The inside of a building, with its walls. It consists of the points that a circle as wide as the
 * widest entrance cannot reach from outside.
 */
final class Enclosure {
  /** The width of the widest entrance, in metres. */
  static final double MAX_ENTRANCE = 6;

  /** A distance above the error of a circle that is drawn as a polygon, in metres. */
  private static final double ROUNDING = 0.02;

  private static final int CORNERS_OF_QUARTER = 32;
  private static final GeometryFactory GEOMETRY = new GeometryFactory();

  private final PreparedGeometry inside;

  private Enclosure(Geometry inside) {
    this.inside = PreparedGeometryFactory.prepare(inside);
  }

  /**
   * Returns the inside of the building that walls enclose, if it contains all zones. Zones that are
   * the whole field do not count; without any others, the result is empty.
   */
  static Optional<Enclosure> of(List<Geometry> walls, List<Zone> zones) {
    List<Zone> drawn = zones.stream().filter(zone -> zone.shape() != Zone.Shape.FIELD).toList();
    if (walls.isEmpty() || drawn.isEmpty()) {
      return Optional.empty();
    }
    Geometry widened = UnaryUnionOp.union(walls.stream().map(Enclosure::widened).toList());
    Enclosure enclosure = new Enclosure(filled(widened).buffer(ROUNDING - MAX_ENTRANCE / 2));
    return drawn.stream().allMatch(enclosure::hasMiddleOf)
        ? Optional.of(enclosure)
        : Optional.empty();
  }

  private static Geometry widened(Geometry wall) {
    return wall.buffer(MAX_ENTRANCE / 2, CORNERS_OF_QUARTER);
  }

  private static Geometry filled(Geometry areas) {
    Geometry[] filled = new Geometry[areas.getNumGeometries()];
    for (int i = 0; i < filled.length; i++) {
      filled[i] = GEOMETRY.createPolygon(((Polygon) areas.getGeometryN(i)).getExteriorRing());
    }
    return GEOMETRY.createGeometryCollection(filled).union();
  }

  private boolean hasMiddleOf(Zone zone) {
    List<Point> corners = zone.points();
    double x = corners.stream().mapToDouble(Point::x).average().orElse(Double.NaN);
    double y = corners.stream().mapToDouble(Point::y).average().orElse(Double.NaN);
    return contains(new Point(x, y));
  }

  /** Whether a point is inside. */
  boolean contains(Point point) {
    return inside.covers(GEOMETRY.createPoint(new Coordinate(point.x(), point.y())));
  }
}
