package org.hificamsim.core.obstacle;

import static org.hificamsim.core.obstacle.Shapes.requireCoordinate;
import static org.hificamsim.core.obstacle.Shapes.requireTransmittance;

import java.util.List;

/**
 * An obstacle to light. Its border, ends and corners belong to it: a line of sight that touches it
 * is blocked or dimmed.
 *
 * <p>Tests are exact for the given coordinates, each taken as the rational number that the double
 * represents. Coordinates are metres between -1e100 and 1e100. In space an obstacle is upright,
 * from its base to its height, and the part of a line of sight at these heights is computed with
 * rounding.
 */
public sealed interface Obstacle {
  /** The part of the light that passes, in [0, 1]; 0 blocks. */
  double transmittance();

  /** The height of the underside above the ground, in metres, 0 or more. */
  double base();

  /** The height of the top, in metres, above the base; infinite if nothing can look over it. */
  double height();

  /** Whether the closed segment between two points, which may be equal, touches the obstacle. */
  boolean touches(double x1, double y1, double x2, double y2);

  /** Whether a point is inside the obstacle or on its border. */
  default boolean contains(double x, double y) {
    return touches(x, y, x, y);
  }

  /**
   * Whether the obstacle meets any line of sight in space from a point at height z to an upright
   * line between two heights. These lines fill a triangle; the segment on the ground below the part
   * of it that is between base and top must touch the obstacle.
   *
   * @param low the lowest height of the upright line, in metres
   * @param high the greatest height of the upright line, in metres
   */
  default boolean touches(
      double x1, double y1, double z, double x2, double y2, double low, double high) {
    double start = Slab.start(z, low, high, base(), height());
    double end = Slab.end(z, low, high, base(), height());
    return start <= end
        && touches(
            Slab.at(x1, x2, start),
            Slab.at(y1, y2, start),
            Slab.at(x1, x2, end),
            Slab.at(y1, y2, end));
  }

  /** The same obstacle with another base and height, in metres. */
  Obstacle between(double from, double to);

  /** The same obstacle from the ground to any height. */
  default Obstacle flat() {
    return between(0, Double.POSITIVE_INFINITY);
  }

  /** Whether the obstacle reaches from the ground to any height. */
  default boolean full() {
    return base() == 0 && height() == Double.POSITIVE_INFINITY;
  }

  /** Whether people cannot pass: the obstacle is solid and its base is 0. */
  default boolean standing() {
    return solid() && base() == 0;
  }

  /** Whether no light passes. */
  default boolean solid() {
    return transmittance() == 0;
  }

  /** A straight wall without thickness. */
  record Wall(
      double x1, double y1, double x2, double y2, double transmittance, double base, double height)
      implements Obstacle {
    /** Creates a wall of infinite height. */
    public Wall(double x1, double y1, double x2, double y2, double transmittance) {
      this(x1, y1, x2, y2, transmittance, 0, Double.POSITIVE_INFINITY);
    }

    /**
     * Checks the shape.
     *
     * @throws IllegalArgumentException if both ends are equal or a number is out of range
     */
    public Wall {
      requireCoordinate(x1);
      requireCoordinate(y1);
      requireCoordinate(x2);
      requireCoordinate(y2);
      requireTransmittance(transmittance);
      Shapes.requireHeights(base, height);
      Shapes.require(
          x1 != x2 || y1 != y2,
          () -> "both ends are (" + x1 + ", " + y1 + "), expected two points");
    }

    @Override
    public boolean touches(double x1, double y1, double x2, double y2) {
      return Segments.touch(x1, y1, x2, y2, this.x1, this.y1, this.x2, this.y2);
    }

    @Override
    public Wall between(double from, double to) {
      return new Wall(x1, y1, x2, y2, transmittance, from, to);
    }
  }

  /**
   * A filled polygon; the last corner is joined to the first.
   *
   * @param points 3 or more, in either direction; the first is not repeated
   */
  record Polygon(List<Point> points, double transmittance, double base, double height)
      implements Obstacle {
    /** Creates an area of infinite height. */
    public Polygon(List<Point> points, double transmittance) {
      this(points, transmittance, 0, Double.POSITIVE_INFINITY);
    }

    /**
     * Checks the shape.
     *
     * @throws IllegalArgumentException if the polygon has fewer than 3 points, no area, or edges
     *     that touch anywhere but at a shared corner
     */
    public Polygon {
      points = List.copyOf(points);
      Shapes.requireSimple(points);
      requireTransmittance(transmittance);
      Shapes.requireHeights(base, height);
    }

    @Override
    public boolean touches(double x1, double y1, double x2, double y2) {
      return Shapes.touches(points, x1, y1, x2, y2) || Shapes.surrounds(points, x1, y1);
    }

    @Override
    public Polygon between(double from, double to) {
      return new Polygon(points, transmittance, from, to);
    }
  }

  /**
   * A round pillar.
   *
   * @param x the x coordinate of the centre, in metres
   * @param y the y coordinate of the centre, in metres
   * @param radius the radius, in metres, above 0
   */
  record Pillar(double x, double y, double radius, double transmittance, double base, double height)
      implements Obstacle {
    /** Creates a pillar of infinite height. */
    public Pillar(double x, double y, double radius, double transmittance) {
      this(x, y, radius, transmittance, 0, Double.POSITIVE_INFINITY);
    }

    /**
     * Checks the shape.
     *
     * @throws IllegalArgumentException if the radius is not above 0 or a number is out of range
     */
    public Pillar {
      requireCoordinate(x);
      requireCoordinate(y);
      Shapes.requireRadius(radius);
      requireTransmittance(transmittance);
      Shapes.requireHeights(base, height);
    }

    @Override
    public boolean touches(double x1, double y1, double x2, double y2) {
      return Discs.touch(x, y, radius, x1, y1, x2, y2);
    }

    @Override
    public Pillar between(double from, double to) {
      return new Pillar(x, y, radius, transmittance, from, to);
    }
  }
}
