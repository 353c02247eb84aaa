package org.hificamsim.tracks.place;

import java.io.IOException;
import java.io.InputStreamReader;
import java.io.LineNumberReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;
import org.hificamsim.core.Place;
import org.hificamsim.core.file.TextLines;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.tracks.place.DrawnPart.Traits;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryCollection;
import org.locationtech.jts.geom.LineString;
import org.locationtech.jts.geom.Polygon;
import org.locationtech.jts.io.ParseException;
import org.locationtech.jts.io.WKTReader;

/**
 * Reads geometries in well-known text (OGC 06-103r4), one after the other, as walls: lines become
 * walls, polygons solid obstacles, and polygons with holes the walls of their sides. Z, the same
 * for all points of a line or polygon, is the height of its walls, metres.
 */
final class WktWalls {
  private final Drawing drawing;
  private static final Pattern REFERENCE_SYSTEM = Pattern.compile("(?i)SRID=[0-9]+");
  private static final int MAX_REFERENCE_SYSTEM = 20;

  private final PlanPoints planPoints;
  private Place geometryPlace;

  WktWalls(Drawing drawing, PlanPoints planPoints) {
    this.drawing = drawing;
    this.planPoints = planPoints;
  }

  void read(Path file) {
    WKTReader reader = new WKTReader();
    try (LineNumberReader in =
        new LineNumberReader(
            new InputStreamReader(TextLines.stream(file), StandardCharsets.UTF_8))) {
      while (skipSpaces(in)) {
        geometryPlace = line(file, in);
        skipReferenceSystem(in);
        try {
          add(reader.read(in));
        } catch (ParseException | IllegalArgumentException e) {
          String problem = e.getMessage().replaceFirst(" \\(line \\d+\\)$", "");
          throw line(file, in).error(problem + ", expected geometries in well-known text");
        }
      }
    } catch (IOException e) {
      throw TextLines.unreadable(file.toString(), 1, e);
    }
  }

  private static Place line(Path file, LineNumberReader in) {
    return new Place(file.toString(), in.getLineNumber() + 1, 1);
  }

  /** Skips white space; returns false at the end of the file. */
  private static boolean skipSpaces(LineNumberReader in) throws IOException {
    int next;
    do {
      in.mark(1);
      next = in.read();
    } while (Character.isWhitespace(next));
    in.reset();
    return next >= 0;
  }

  /** Skips what PostGIS writes before a geometry, such as {@code SRID=25832;}. */
  private static void skipReferenceSystem(LineNumberReader in) throws IOException {
    in.mark(MAX_REFERENCE_SYSTEM);
    StringBuilder start = new StringBuilder();
    int next = in.read();
    while (next >= 0 && next != ';' && start.length() < MAX_REFERENCE_SYSTEM - 1) {
      start.append((char) next);
      next = in.read();
    }
    if (next != ';' || !REFERENCE_SYSTEM.matcher(start).matches()) {
      in.reset();
    }
  }

  private void add(Geometry geometry) {
    if (geometry instanceof GeometryCollection collection) { // also of lines or of polygons
      for (int i = 0; i < collection.getNumGeometries(); i++) {
        add(collection.getGeometryN(i));
      }
    } else if (geometry.isEmpty()) {
      return;
    } else if (geometry instanceof Polygon polygon) {
      List<Point> border = points(polygon.getExteriorRing());
      List<List<Point>> holes = new ArrayList<>();
      for (int i = 0; i < polygon.getNumInteriorRing(); i++) {
        holes.add(points(polygon.getInteriorRingN(i)));
      }
      add(new DrawnShape.Area(border, holes, holes.isEmpty()), polygon);
    } else if (geometry instanceof LineString line) {
      add(new DrawnShape.Line(points(line)), line);
    } else {
      drawing.leaveOut("point");
    }
  }

  private void add(DrawnShape shape, Geometry geometry) {
    double[] heights =
        Arrays.stream(geometry.getCoordinates()).mapToDouble(Coordinate::getZ).distinct().toArray();
    if (heights.length > 1) {
      throw geometryPlace.error(
          "Z is %s and %s, expected one height for a line or polygon", heights[0], heights[1]);
    }
    Traits traits =
        Double.isNaN(heights[0])
            ? Traits.NONE
            : Traits.NONE.withHeight(DrawnPart.height(geometryPlace, heights[0]));
    drawing.add(geometryPlace, shape, traits);
  }

  private List<Point> points(LineString line) {
    return Arrays.stream(line.getCoordinates()).map(this::point).toList();
  }

  private Point point(Coordinate position) {
    if (!Double.isFinite(position.x) || !Double.isFinite(position.y)) {
      throw geometryPlace.error("a coordinate is " + position + ", expected numbers");
    }
    return planPoints.point(geometryPlace, position.x, position.y);
  }
}
