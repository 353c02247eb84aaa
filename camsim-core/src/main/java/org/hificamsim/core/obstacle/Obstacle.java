package org.hificamsim.core.obstacle;

import static org.hificamsim.core.obstacle.Shapes.requireCoordinate;
import static org.hificamsim.core.obstacle.Shapes.requireTransmittance;

import java.util.List;

/**
 * Something that stands in the way of light. Its border belongs to it, and so do its ends and
 * corners: a line of sight that touches it is blocked or dimmed.
 *
 * <p>Whether it is touched is decided exactly for the coordinates given, each taken as the rational
 * number that the double is. Coordinates are metres between -1e100 and 1e100.
 */
public sealed interface Obstacle {
  /** The part of the light that passes, in [0, 1]; 0 blocks. */
  double transmittance();

  /** Whether the closed segment between two points, which may be one, has a point of it. */
  boolean touches(double x1, double y1, double x2, double y2);

  /** Whether a point is inside or on the border. */
  default boolean contains(double x, double y) {
    return touches(x, y, x, y);
  }

  /** Whether nothing passes. */
  default boolean solid() {
    return transmittance() == 0;
  }

  /** A straight wall without thickness. */
  record Wall(double x1, double y1, double x2, double y2, double transmittance)
      implements Obstacle {
    /**
     * Checks the shape.
     *
     * @throws IllegalArgumentException where its ends are one point, or a number is out of range
     */
    public Wall {
      requireCoordinate(x1);
      requireCoordinate(y1);
      requireCoordinate(x2);
      requireCoordinate(y2);
      requireTransmittance(transmittance);
      Shapes.require(
          x1 != x2 || y1 != y2,
          () -> "both ends are (" + x1 + ", " + y1 + "), expected two points");
    }

    @Override
    public boolean touches(double x1, double y1, double x2, double y2) {
      return Segments.touch(x1, y1, x2, y2, this.x1, this.y1, this.x2, this.y2);
    }
  }

  /**
   * An area within corners; the last is joined to the first. The area belongs to it.
   *
   * @param points 3 or more, in either direction; the first is not repeated
   */
  record Polygon(List<Point> points, double transmittance) implements Obstacle {
    /**
     * Checks the shape.
     *
     * @throws IllegalArgumentException where it has fewer than 3 points, no area, or edges that
     *     touch elsewhere than at the corner that they share
     */
    public Polygon {
      points = List.copyOf(points);
      Shapes.requireSimple(points);
      requireTransmittance(transmittance);
    }

    @Override
    public boolean touches(double x1, double y1, double x2, double y2) {
      return Shapes.touches(points, x1, y1, x2, y2) || Shapes.surrounds(points, x1, y1);
    }
  }

  /**
   * A round pillar.
   *
   * @param x of its centre
   * @param y of its centre
   * @param radius metres, above 0
   */
  record Pillar(double x, double y, double radius, double transmittance) implements Obstacle {
    /**
     * Checks the shape.
     *
     * @throws IllegalArgumentException where the radius is not above 0, or a number is out of range
     */
    public Pillar {
      requireCoordinate(x);
      requireCoordinate(y);
      Shapes.requireRadius(radius);
      requireTransmittance(transmittance);
    }

    @Override
    public boolean touches(double x1, double y1, double x2, double y2) {
      return Discs.touch(x, y, radius, x1, y1, x2, y2);
    }
  }
}
