package org.hificamsim.presentation.view;

import java.util.List;
import org.hificamsim.core.InputException;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Point;

/** The kinds of solid obstacles that a user can draw between two points. */
enum DrawnObstacle {
  /** A wall between the two places. */
  WALL {
    @Override
    Obstacle between(Point from, Point to) {
      return new Obstacle.Wall(from.x(), from.y(), to.x(), to.y(), 0);
    }
  },

  /** A shelf, a counter or a block: a rectangle between opposite corners. */
  SHELF {
    @Override
    Obstacle between(Point from, Point to) {
      return new Obstacle.Polygon(
          List.of(from, new Point(to.x(), from.y()), to, new Point(from.x(), to.y())), 0);
    }
  },

  /** A round pillar, from its centre to its border. */
  PILLAR {
    @Override
    Obstacle between(Point from, Point to) {
      double radius = Math.hypot(to.x() - from.x(), to.y() - from.y());
      return new Obstacle.Pillar(from.x(), from.y(), radius, 0);
    }
  };

  abstract Obstacle between(Point from, Point to);

  /**
   * Returns the obstacle.
   *
   * @param height the height of its top, in metres; null if nothing can look over it
   * @throws InputException if it has no size, or the height is not above 0
   */
  Obstacle obstacle(Point from, Point to, Double height) {
    if (from.equals(to)) {
      throw InputException.of("both ends are (%s, %s), expected two places", from.x(), from.y());
    }
    try {
      Obstacle endless = between(from, to);
      return height == null ? endless : endless.between(0, height);
    } catch (IllegalArgumentException e) {
      throw new InputException(e.getMessage(), e);
    }
  }
}
