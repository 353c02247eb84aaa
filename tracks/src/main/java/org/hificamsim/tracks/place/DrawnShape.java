package org.hificamsim.tracks.place;

import java.awt.geom.Rectangle2D;
import java.util.List;
import org.hificamsim.core.obstacle.Point;

/** A shape of a drawing, in metres. */
sealed interface DrawnShape {
  /** The smallest rectangle around the shape. */
  Rectangle2D bounds();

  /** The number of points that the shape is stored with. */
  int points();

  private static Rectangle2D bounds(List<Point> points) {
    Point first = points.get(0);
    Rectangle2D bounds = new Rectangle2D.Double(first.x(), first.y(), 0, 0);
    points.forEach(point -> bounds.add(point.x(), point.y()));
    return bounds;
  }

  /**
   * A line through points, from which walls are made.
   *
   * @param corners one corner or more
   */
  record Line(List<Point> corners) implements DrawnShape {
    @Override
    public Rectangle2D bounds() {
      return DrawnShape.bounds(corners);
    }

    @Override
    public int points() {
      return corners.size();
    }
  }

  /**
   * An area with its holes. Each border may or may not repeat its first point at its end.
   *
   * @param border corners of the outer border, one or more
   * @param solid whether the area is filled; otherwise its borders are walls
   */
  record Area(List<Point> border, List<List<Point>> holes, boolean solid) implements DrawnShape {
    Area(List<Point> border, boolean solid) {
      this(border, List.of(), solid);
    }

    @Override
    public Rectangle2D bounds() {
      return DrawnShape.bounds(border);
    }

    @Override
    public int points() {
      return border.size() + holes.stream().mapToInt(List::size).sum();
    }
  }

  /**
   * A round pillar.
   *
   * @param radius the radius in metres, above 0
   */
  record Disc(Point centre, double radius) implements DrawnShape {
    @Override
    public Rectangle2D bounds() {
      return new Rectangle2D.Double(
          centre.x() - radius, centre.y() - radius, 2 * radius, 2 * radius);
    }

    @Override
    public int points() {
      return 1;
    }
  }
}
