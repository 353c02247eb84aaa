package org.hificamsim.tracks.place;

import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.Place;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.tracks.format.Unit;
import org.hificamsim.tracks.ground.LocalProjection;

/** Collects the obstacles that lines and rings make, in metres. */
final class WallCollector {
  private static final double PER_MILLIMETRE = 1e3;

  private final Unit unit;
  private final LocalProjection projection;
  private final List<Obstacle> obstacles = new ArrayList<>();

  WallCollector(Unit unit, LocalProjection projection) {
    this.unit = unit;
    this.projection = projection;
  }

  /** Converts a point of the file to metres, rounded to the millimetre. */
  Point point(Place place, double x, double y) {
    if (unit == Unit.DEG) {
      Point metres = projection.metres(place, x, y);
      return rounded(metres.x(), metres.y());
    }
    return rounded(x * unit.metres(), y * unit.metres());
  }

  static Point rounded(double x, double y) {
    return new Point(
        Math.rint(x * PER_MILLIMETRE) / PER_MILLIMETRE,
        Math.rint(y * PER_MILLIMETRE) / PER_MILLIMETRE);
  }

  /** Adds walls between consecutive points, except between equal ones. */
  void line(List<Point> points) {
    for (int i = 1; i < points.size(); i++) {
      Point from = points.get(i - 1);
      Point to = points.get(i);
      if (!from.equals(to)) {
        obstacles.add(new Obstacle.Wall(from.x(), from.y(), to.x(), to.y(), 0));
      }
    }
  }

  /** Adds a solid polygon, or its sides if they cross each other; a single point adds nothing. */
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
      obstacles.add(new Obstacle.Polygon(corners, 0));
    } catch (IllegalArgumentException e) {
      corners.add(corners.get(0));
      line(corners);
    }
  }

  /** The number of obstacles so far. */
  int count() {
    return obstacles.size();
  }

  /**
   * Sets the height of all obstacles from an index on.
   *
   * @param place of the height in the file
   * @param height metres, above 0
   */
  void raise(Place place, int from, double height) {
    if (!(height > 0 && height <= 1e9)) {
      throw place.error("height is " + height + ", expected a number above 0 and at most 1e9 (m)");
    }
    for (int i = from; i < obstacles.size(); i++) {
      obstacles.set(i, obstacles.get(i).between(0, height));
    }
  }

  List<Obstacle> obstacles() {
    return obstacles;
  }
}
