package org.hificamsim.tracks.place;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.tracks.place.DrawnShape.Area;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.LineString;
import org.locationtech.jts.geom.LinearRing;
import org.locationtech.jts.geom.Polygon;
import org.locationtech.jts.geom.util.GeometryFixer;
import org.locationtech.jts.geom.util.LinearComponentExtracter;
import org.locationtech.jts.geom.util.PolygonExtracter;
import org.locationtech.jts.index.strtree.STRtree;
import org.locationtech.jts.operation.union.UnaryUnionOp;

/**
 * Reads the outermost areas of a drawing as the area that people walk in: the borders of their
 * union become walls, and areas within them stay obstacles.
 */
final class WalkableArea {
  private static final GeometryFactory GEOMETRY = new GeometryFactory();

  private final List<DrawnPart> parts;
  private final List<DrawnPart> outermost;
  private final Geometry union;

  /**
   * @param parts all parts of a drawing
   */
  WalkableArea(List<DrawnPart> parts) {
    this.parts = parts;
    List<DrawnPart> areas = parts.stream().filter(part -> part.shape() instanceof Area).toList();
    List<Geometry> polygons = areas.stream().map(part -> polygon((Area) part.shape())).toList();
    boolean[] inner = inner(polygons);
    int[] outer = IntStream.range(0, inner.length).filter(i -> !inner[i]).toArray();
    outermost = Arrays.stream(outer).mapToObj(areas::get).toList();
    union = UnaryUnionOp.union(Arrays.stream(outer).mapToObj(polygons::get).toList(), GEOMETRY);
  }

  /**
   * Returns the parts of the drawing with the borders of walkable areas in place of these areas.
   */
  List<DrawnPart> borders() {
    List<DrawnPart> result = new ArrayList<>(parts);
    result.removeAll(new HashSet<>(outermost));
    double[] heights = outermost.stream().mapToDouble(DrawnPart::height).distinct().toArray();
    double height = heights.length == 1 ? heights[0] : Double.POSITIVE_INFINITY;
    for (Object line : LinearComponentExtracter.getLines(union)) {
      List<Point> points = points(((LineString) line).getCoordinates());
      result.add(new DrawnPart(new DrawnShape.Line(points), height));
    }
    return result;
  }

  /** Returns the outer borders of the walkable areas. */
  List<List<Point>> outerBorders() {
    List<List<Point>> borders = new ArrayList<>();
    for (Object polygon : PolygonExtracter.getPolygons(union)) {
      LinearRing ring = ((Polygon) polygon).getExteriorRing();
      borders.add(ObstacleMaker.corners(points(ring.getCoordinates())));
    }
    return borders;
  }

  /** Whether a border surrounds a point. */
  static boolean holds(List<Point> border, Point point) {
    return polygon(new Area(border, true))
        .contains(GEOMETRY.createPoint(new Coordinate(point.x(), point.y())));
  }

  /** Whether each polygon lies within a larger one, or within an equal one that is before it. */
  private static boolean[] inner(List<Geometry> polygons) {
    STRtree index = new STRtree();
    Integer[] bySize =
        IntStream.range(0, polygons.size())
            .boxed()
            .sorted(Comparator.comparingDouble(i -> -polygons.get(i).getArea()))
            .toArray(Integer[]::new);
    int[] rank = new int[polygons.size()];
    IntStream.range(0, rank.length).forEach(order -> rank[bySize[order]] = order);
    IntStream.range(0, rank.length)
        .forEach(i -> index.insert(polygons.get(i).getEnvelopeInternal(), i));
    boolean[] inner = new boolean[polygons.size()];
    for (int i = 0; i < inner.length; i++) {
      Geometry polygon = polygons.get(i);
      int own = rank[i];
      for (Object other : index.query(polygon.getEnvelopeInternal())) {
        int number = (Integer) other;
        inner[i] |= rank[number] < own && polygons.get(number).covers(polygon);
      }
    }
    return inner;
  }

  private static Geometry polygon(Area area) {
    LinearRing[] holes = area.holes().stream().map(WalkableArea::ring).toArray(LinearRing[]::new);
    Polygon polygon = GEOMETRY.createPolygon(ring(area.border()), holes);
    return polygon.isValid() ? polygon : GeometryFixer.fix(polygon);
  }

  /** A closed ring; an empty one if there are fewer than three corners. */
  private static LinearRing ring(List<Point> border) {
    List<Point> corners = ObstacleMaker.corners(border);
    if (corners.size() < 3) {
      return GEOMETRY.createLinearRing();
    }
    Coordinate[] ring = new Coordinate[corners.size() + 1];
    for (int i = 0; i < ring.length; i++) {
      Point corner = corners.get(i % corners.size());
      ring[i] = new Coordinate(corner.x(), corner.y());
    }
    return GEOMETRY.createLinearRing(ring);
  }

  private static List<Point> points(Coordinate[] coordinates) {
    return Arrays.stream(coordinates)
        .map(coordinate -> PlanPoints.rounded(coordinate.x, coordinate.y))
        .toList();
  }
}
