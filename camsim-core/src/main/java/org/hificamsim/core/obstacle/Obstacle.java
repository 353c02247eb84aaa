package org.hificamsim.core.obstacle;

import static org.hificamsim.core.obstacle.Shapes.requireCoordinate;
import static org.hificamsim.core.obstacle.Shapes.requireTransmittance;

import java.util.List;

/**
 * Something that stands in the way of light. Its border belongs to it, and so do its ends and
 * corners: a line of sight that touches it is blocked or dimmed.
 *
 * <p>Whether it is touched is decided exactly for the coordinates given, each taken as the rational
 * number that the double is. Coordinates are metres between -1e100 and 1e100. In space an obstacle
 * is upright, from its base to its height, and a sight line is rounded to where it is as high.
 */
public sealed interface Obstacle {
  /** The part of the light that passes, in [0, 1]; 0 blocks. */
  double transmittance();

  /** The height of its underside above the ground, metres, 0 or more. */
  double base();

  /** The height of its top, metres, above the base; infinite where nothing looks over it. */
  double height();

  /** Whether the closed segment between two points, which may be one, has a point of it. */
  boolean touches(double x1, double y1, double x2, double y2);

  /** Whether a point is inside or on the border. */
  default boolean contains(double x, double y) {
    return touches(x, y, x, y);
  }

  /**
   * Whether it meets a sight line in space: any from a point at height z to what is between two
   * heights of an upright line. These lines fill a triangle; the part of it that is as high as the
   * obstacle has a segment of the plan below it, which has to touch.
   *
   * @param low the least height of what is looked at, metres
   * @param high the greatest, metres
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

  /** The same from another base to another height, metres. */
  Obstacle between(double from, double to);

  /** The same from the ground to any height. */
  default Obstacle flat() {
    return between(0, Double.POSITIVE_INFINITY);
  }

  /** Whether it reaches from the ground to any height. */
  default boolean full() {
    return base() == 0 && height() == Double.POSITIVE_INFINITY;
  }

  /** Whether it stands in the way of people: those with a base above 0 do not. */
  default boolean standing() {
    return solid() && base() == 0;
  }

  /** Whether nothing passes. */
  default boolean solid() {
    return transmittance() == 0;
  }

  /** A straight wall without thickness. */
  record Wall(
      double x1, double y1, double x2, double y2, double transmittance, double base, double height)
      implements Obstacle {
    /** A wall that nothing looks over. */
    public Wall(double x1, double y1, double x2, double y2, double transmittance) {
      this(x1, y1, x2, y2, transmittance, 0, Double.POSITIVE_INFINITY);
    }

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
   * An area within corners; the last is joined to the first. The area belongs to it.
   *
   * @param points 3 or more, in either direction; the first is not repeated
   */
  record Polygon(List<Point> points, double transmittance, double base, double height)
      implements Obstacle {
    /** An area that nothing looks over. */
    public Polygon(List<Point> points, double transmittance) {
      this(points, transmittance, 0, Double.POSITIVE_INFINITY);
    }

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
   * @param x of its centre
   * @param y of its centre
   * @param radius metres, above 0
   */
  record Pillar(double x, double y, double radius, double transmittance, double base, double height)
      implements Obstacle {
    /** A pillar that nothing looks over. */
    public Pillar(double x, double y, double radius, double transmittance) {
      this(x, y, radius, transmittance, 0, Double.POSITIVE_INFINITY);
    }

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
