package org.hificamsim.core.obstacle;

import java.util.List;
import java.util.function.Supplier;

/** Checks the numbers of shapes, and tests polygons against points and segments. */
final class Shapes {
  private static final double MAX_COORDINATE = 1e100;

  private Shapes() {}

  static void require(boolean valid, Supplier<String> problem) {
    if (!valid) {
      throw new IllegalArgumentException(problem.get());
    }
  }

  static void requireCoordinate(double value) {
    require(
        Math.abs(value) <= MAX_COORDINATE,
        () -> "coordinate is " + value + ", expected a number between -1e100 and 1e100");
  }

  static void requireTransmittance(double value) {
    require(
        value >= 0 && value <= 1,
        () -> "transmittance is " + value + ", expected a number between 0 and 1");
  }

  static void requireHeights(double base, double height) {
    require(
        base >= 0 && base <= MAX_COORDINATE && height > base,
        () ->
            "base is "
                + base
                + " and height "
                + height
                + ", expected 0 or more, and a height above");
  }

  static void requireRadius(double value) {
    require(
        value > 0 && value <= MAX_COORDINATE,
        () -> "radius is " + value + ", expected a number above 0, and 1e100 at most");
  }

  static void requireSimple(List<Point> points) {
    require(
        points.size() >= 3, () -> "polygon has " + points.size() + " points, expected 3 or more");
    points.forEach(point -> requireCoordinate(point.x()));
    points.forEach(point -> requireCoordinate(point.y()));
    require(
        !points.get(0).equals(points.get(points.size() - 1)),
        () -> "the last point of the polygon repeats the first, expected each point once");
    requireArea(points);
    for (int i = 0; i < points.size(); i++) {
      for (int j = i + 1; j < points.size(); j++) {
        requireApart(points, i, j);
      }
    }
  }

  private static void requireArea(List<Point> points) {
    Point first = points.get(0);
    Point other = points.stream().filter(point -> !point.equals(first)).findFirst().orElse(first);
    require(
        points.stream().anyMatch(point -> turn(first, other, point) != 0),
        () -> "all points of the polygon are on one line, expected an area");
  }

  /** Checks that edges i and j, with i below j, have at most a corner in common. */
  private static void requireApart(List<Point> points, int i, int j) {
    require(
        !meet(points, i, j),
        () ->
            "edges "
                + (i + 1)
                + " and "
                + (j + 1)
                + " of the polygon touch, expected edges that share corners with their neighbours"
                + " alone");
  }

  private static boolean meet(List<Point> points, int i, int j) {
    if (j == i + 1) {
      return foldsBack(points, i);
    }
    if (i == 0 && j == points.size() - 1) {
      return foldsBack(points, j);
    }
    Point from = points.get(i);
    Point to = next(points, i);
    return touches(points.get(j), next(points, j), from.x(), from.y(), to.x(), to.y());
  }

  /** Whether edge i and the next one have more in common than their shared corner. */
  private static boolean foldsBack(List<Point> points, int i) {
    Point from = points.get(i);
    Point corner = next(points, i);
    Point to = next(points, (i + 1) % points.size());
    return from.equals(corner)
        || corner.equals(to)
        || touches(corner, to, from.x(), from.y(), from.x(), from.y())
        || touches(from, corner, to.x(), to.y(), to.x(), to.y());
  }

  /** Whether a segment touches an edge of a polygon. */
  static boolean touches(List<Point> points, double x1, double y1, double x2, double y2) {
    for (int i = 0; i < points.size(); i++) {
      if (touches(points.get(i), next(points, i), x1, y1, x2, y2)) {
        return true;
      }
    }
    return false;
  }

  /** Whether a polygon surrounds a point that is on no edge: counts the edges to its right. */
  static boolean surrounds(List<Point> points, double x, double y) {
    Point point = new Point(x, y);
    boolean inside = false;
    for (int i = 0; i < points.size(); i++) {
      Point from = points.get(i);
      Point to = next(points, i);
      boolean rises = to.y() > y;
      boolean crosses = from.y() > y != rises;
      inside ^= crosses && turn(from, to, point) > 0 == rises;
    }
    return inside;
  }

  private static Point next(List<Point> points, int i) {
    return points.get(i + 1 == points.size() ? 0 : i + 1);
  }

  private static boolean touches(Point from, Point to, double x1, double y1, double x2, double y2) {
    return Segments.touch(x1, y1, x2, y2, from.x(), from.y(), to.x(), to.y());
  }

  private static int turn(Point a, Point b, Point c) {
    return Orientation.of(a.x(), a.y(), b.x(), b.y(), c.x(), c.y());
  }
}
