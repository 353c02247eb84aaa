package org.hificamsim.tracks.place;

import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.FlatteningPathIterator;
import java.awt.geom.PathIterator;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.Place;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.tracks.place.DrawnPart.Traits;

/**
 * Adds an outline to a drawing; curves become chords.
 *
 * @param place the outline's place in the file
 * @param toMetres the transform from the coordinates of the outline to metres
 */
record OutlineMaker(Drawing drawing, Place place, AffineTransform toMetres, Traits traits) {
  /** The largest distance of a chord from its curve, in metres. */
  private static final double FLATNESS = 0.02;

  /** The kind of an outline. */
  enum Kind {
    /** Lines, each of which is an area without an inside if it is closed. */
    LINES,
    /** The border of an area without an inside. */
    BORDER,
    /** The border of a filled area. */
    SOLID
  }

  void add(Shape outline, Kind kind) {
    List<Point> part = new ArrayList<>();
    boolean isClosed = false;
    double[] coordinates = new double[6];
    PathIterator path = new FlatteningPathIterator(outline.getPathIterator(toMetres), FLATNESS);
    for (; !path.isDone(); path.next()) {
      int segment = path.currentSegment(coordinates);
      if (segment == PathIterator.SEG_MOVETO) {
        add(part, isClosed, kind);
        part = new ArrayList<>();
      }
      isClosed = segment == PathIterator.SEG_CLOSE;
      part.add(isClosed ? part.get(0) : PlanPoints.checked(place, coordinates[0], coordinates[1]));
    }
    add(part, isClosed, kind);
  }

  private void add(List<Point> points, boolean isClosed, Kind kind) {
    if (points.size() > 1) {
      boolean isArea = isClosed || kind != Kind.LINES;
      drawing.add(
          place,
          isArea ? new DrawnShape.Area(points, kind == Kind.SOLID) : new DrawnShape.Line(points),
          traits);
    }
  }

  /** Adds a circle as a pillar, or as a solid area where the transform makes it an ellipse. */
  void addCircle(Shape circle) {
    if (!isSimilarity()) {
      add(circle, Kind.SOLID);
      return;
    }
    Rectangle2D bounds = circle.getBounds2D();
    double[] centre = {bounds.getCenterX(), bounds.getCenterY()};
    toMetres.transform(centre, 0, centre, 0, 1);
    double exact = bounds.getWidth() / 2 * Math.sqrt(Math.abs(toMetres.getDeterminant()));
    double radius = PlanPoints.checked(place, exact, 0).x();
    if (radius > 0) {
      Point middle = PlanPoints.checked(place, centre[0], centre[1]);
      drawing.add(place, new DrawnShape.Disc(middle, radius), traits);
    }
  }

  private boolean isSimilarity() {
    double a = toMetres.getScaleX();
    double b = toMetres.getShearY();
    double c = toMetres.getShearX();
    double d = toMetres.getScaleY();
    double size = a * a + b * b;
    return Math.abs(size - c * c - d * d) <= 1e-9 * size && Math.abs(a * c + b * d) <= 1e-9 * size;
  }
}
