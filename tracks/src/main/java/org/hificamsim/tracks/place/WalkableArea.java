package org.hificamsim.tracks.place;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
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
 * Reads the outermost areas of a drawing as the area that people walk in: what borders their union
 * is a wall, and areas within them stay what they are.
 */
final class WalkableArea {
  private static final GeometryFactory GEOMETRY = new GeometryFactory();

  private WalkableArea() {}

  /** Returns the parts of a drawing with the borders of walkable areas in place of these areas. */
  static List<DrawnPart> borders(List<DrawnPart> parts) {
    List<DrawnPart> outermost = outermost(parts);
    List<DrawnPart> result = new ArrayList<>(parts);
    result.removeAll(outermost);
    double[] heights = outermost.stream().mapToDouble(DrawnPart::height).distinct().toArray();
    double height = heights.length == 1 ? heights[0] : Double.POSITIVE_INFINITY;
    for (Object line : LinearComponentExtracter.getLines(union(outermost))) {
      List<Point> points = points(((LineString) line).getCoordinates());
      result.add(new DrawnPart(new DrawnShape.Line(points), height));
    }
    return result;
  }

  /** Returns the outer borders of the walkable areas. */
  static List<List<Point>> outerBorders(List<DrawnPart> parts) {
    List<List<Point>> borders = new ArrayList<>();
    for (Object polygon : PolygonExtracter.getPolygons(union(outermost(parts)))) {
      LinearRing ring = ((Polygon) polygon).getExteriorRing();
      borders.add(ObstacleMaker.corners(points(ring.getCoordinates())));
    }
    return borders;
  }

  private static List<DrawnPart> outermost(List<DrawnPart> parts) {
    List<DrawnPart> areas = parts.stream().filter(part -> part.shape() instanceof Area).toList();
    boolean[] inner = inner(areas.stream().map(part -> polygon((Area) part.shape())).toList());
    return IntStream.range(0, inner.length).filter(i -> !inner[i]).mapToObj(areas::get).toList();
  }

  private static Geometry union(List<DrawnPart> areas) {
    return UnaryUnionOp.union(
        areas.stream().map(part -> polygon((Area) part.shape())).toList(), GEOMETRY);
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
    IntStream.range(0, rank.length).forEach(place -> rank[bySize[place]] = place);
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
    return Arrays.stream(coordinates).map(at -> PlanPoints.rounded(at.x, at.y)).toList();
  }
}
