package org.hificamsim.tracks.place;

import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.Place;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.tracks.format.Unit;
import org.hificamsim.tracks.ground.LocalProjection;

/** Makes obstacles of lines and rings, in metres. */
final class WallCollector {
  private static final double MILLI = 1e3;

  private final Unit unit;
  private final LocalProjection projection;
  private final List<Obstacle> all = new ArrayList<>();

  WallCollector(Unit unit, LocalProjection projection) {
    this.unit = unit;
    this.projection = projection;
  }

  /** A point of the file in metres, to the millimetre. */
  Point point(Place place, double x, double y) {
    if (unit == Unit.DEG) {
      Point metres = projection.metres(place, x, y);
      return rounded(metres.x(), metres.y());
    }
    return rounded(x * unit.metres(), y * unit.metres());
  }

  static Point rounded(double x, double y) {
    return new Point(Math.rint(x * MILLI) / MILLI, Math.rint(y * MILLI) / MILLI);
  }

  /** Adds the segments between points; one without length is left out. */
  void line(List<Point> points) {
    for (int i = 1; i < points.size(); i++) {
      Point from = points.get(i - 1);
      Point to = points.get(i);
      if (!from.equals(to)) {
        all.add(new Obstacle.Wall(from.x(), from.y(), to.x(), to.y(), 0));
      }
    }
  }

  /** Adds a solid polygon; where its sides touch each other, its sides. A point is no polygon. */
  void ring(List<Point> points) {
    List<Point> corners = new ArrayList<>();
    for (Point point : points) {
      if (corners.isEmpty() || !corners.get(corners.size() - 1).equals(point)) {
        corners.add(point);
      }
    }
    if (corners.size() > 1 && corners.get(0).equals(corners.get(corners.size() - 1))) {
      corners.remove(corners.size() - 1);
    }
    if (corners.size() < 2) {
      return;
    }
    try {
      all.add(new Obstacle.Polygon(corners, 0));
    } catch (IllegalArgumentException e) {
      corners.add(corners.get(0));
      line(corners);
    }
  }

  /** How many there are so far. */
  int count() {
    return all.size();
  }

  /**
   * Gives all from a number on a height.
   *
   * @param height metres, above 0
   */
  void raise(Place place, int from, double height) {
    if (!(height > 0 && height <= 1e9)) {
      throw place.error("height is " + height + ", expected a number above 0 and at most 1e9 (m)");
    }
    for (int i = from; i < all.size(); i++) {
      all.set(i, all.get(i).between(0, height));
    }
  }

  List<Obstacle> all() {
    return all;
  }
}
