package org.hificamsim.tracks.place;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.hificamsim.core.Place;
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
 * Adds geometries in well-known text (OGC 06-103r4) to a drawing: lines become walls, polygons
 * solid obstacles, and polygons with holes the walls of their sides. Z, the same for all points of
 * a line or polygon, is the height of its walls, in metres. Curves and surfaces are left out.
 *
 * @param areWalkable whether people walk in the polygons, so that their borders are walls
 */
record WktShapes(Drawing drawing, PlanPoints planPoints, boolean areWalkable) {
  /** The prefix of PostGIS before a geometry, such as {@code SRID=25832;}. */
  private static final Pattern REFERENCE_SYSTEM = Pattern.compile("^\\s*(?i:SRID)=[0-9]+;");

  private static final Pattern OTHER =
      Pattern.compile(
          "(?i)Unknown geometry type: (CIRCULARSTRING|COMPOUNDCURVE|CURVEPOLYGON|MULTICURVE"
              + "|MULTISURFACE|TRIANGLE|TIN|POLYHEDRALSURFACE).*");

  private static final Pattern LINE = Pattern.compile("\\(line (\\d+)\\)$");

  /**
   * Adds a geometry.
   *
   * @param place the place where its text begins
   * @param traits height and labels that the file gives to it
   * @throws org.hificamsim.core.InputException if the text is none
   */
  void add(Place place, String text, Traits traits) {
    try {
      Geometry geometry = new WKTReader().read(REFERENCE_SYSTEM.matcher(text).replaceFirst(""));
      add(new Source(place, traits), geometry);
    } catch (ParseException | IllegalArgumentException e) {
      String problem = String.valueOf(e.getMessage());
      Matcher other = OTHER.matcher(problem);
      if (!other.lookingAt()) {
        throw fault(place, problem);
      }
      drawing.leaveOut(other.group(1).toLowerCase(Locale.ROOT));
    }
  }

  private static RuntimeException fault(Place place, String problem) {
    Matcher line = LINE.matcher(problem);
    int lines = line.find() ? Integer.parseInt(line.group(1)) - 1 : 0;
    return new Place(place.file(), place.line() + lines, place.column())
        .error(LINE.matcher(problem).replaceFirst("").strip() + ", expected well-known text");
  }

  /** The place where a geometry begins, and its height and labels. */
  private record Source(Place place, Traits traits) {}

  private void add(Source source, Geometry geometry) {
    if (geometry instanceof GeometryCollection collection) { // also of lines or of polygons
      for (int i = 0; i < collection.getNumGeometries(); i++) {
        add(source, collection.getGeometryN(i));
      }
    } else if (geometry.isEmpty()) {
      return;
    } else if (geometry instanceof Polygon polygon) {
      List<Point> border = points(source, polygon.getExteriorRing());
      List<List<Point>> holes = new ArrayList<>();
      for (int i = 0; i < polygon.getNumInteriorRing(); i++) {
        holes.add(points(source, polygon.getInteriorRingN(i)));
      }
      boolean isSolid = holes.isEmpty() && !areWalkable;
      add(source, new DrawnShape.Area(border, holes, isSolid), polygon);
    } else if (geometry instanceof LineString line) {
      add(source, new DrawnShape.Line(points(source, line)), line);
    } else {
      drawing.leaveOut("point");
    }
  }

  private void add(Source source, DrawnShape shape, Geometry geometry) {
    double[] heights =
        Arrays.stream(geometry.getCoordinates()).mapToDouble(Coordinate::getZ).distinct().toArray();
    Traits traits =
        Double.isNaN(heights[0])
            ? source.traits
            : source.traits.withHeight(drawing.height(() -> height(source.place, heights)));
    drawing.add(source.place, shape, traits);
  }

  private static double height(Place place, double[] heights) {
    if (heights.length > 1) {
      throw place.error(
          "Z is %s and %s, expected one height for a line or polygon", heights[0], heights[1]);
    }
    return DrawnPart.height(place, heights[0]);
  }

  private List<Point> points(Source source, LineString line) {
    return Arrays.stream(line.getCoordinates()).map(position -> point(source, position)).toList();
  }

  private Point point(Source source, Coordinate position) {
    if (!Double.isFinite(position.x) || !Double.isFinite(position.y)) {
      throw source.place.error("a coordinate is " + position + ", expected numbers");
    }
    return planPoints.point(source.place, position.x, position.y);
  }
}
