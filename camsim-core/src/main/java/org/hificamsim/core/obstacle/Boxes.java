package org.hificamsim.core.obstacle;

import java.util.List;

/**
 * Boxes around obstacles, in one array. Most obstacles are far from a short segment, and a box says
 * so fast; without it, segments in line with a far wall are decided by long numbers, which take
 * memory.
 */
final class Boxes {
  private static final int SIDES = 4;

  private final double[] sides;

  Boxes(List<Obstacle> obstacles) {
    sides = new double[SIDES * obstacles.size()];
    for (int i = 0; i < obstacles.size(); i++) {
      set(SIDES * i, obstacles.get(i));
    }
  }

  private void set(int at, Obstacle obstacle) {
    double[] box = {Double.MAX_VALUE, Double.MAX_VALUE, -Double.MAX_VALUE, -Double.MAX_VALUE};
    if (obstacle instanceof Obstacle.Wall wall) {
      widen(box, wall.x1(), wall.y1(), 0);
      widen(box, wall.x2(), wall.y2(), 0);
    } else if (obstacle instanceof Obstacle.Pillar pillar) {
      widen(box, pillar.x(), pillar.y(), pillar.radius());
    } else if (obstacle instanceof Obstacle.Polygon polygon) {
      polygon.points().forEach(point -> widen(box, point.x(), point.y(), 0));
    }
    System.arraycopy(box, 0, sides, at, SIDES);
  }

  /** Rounded outwards. */
  private static void widen(double[] box, double x, double y, double by) {
    box[0] = Math.min(box[0], Math.nextDown(x - by));
    box[1] = Math.min(box[1], Math.nextDown(y - by));
    box[2] = Math.max(box[2], Math.nextUp(x + by));
    box[3] = Math.max(box[3], Math.nextUp(y + by));
  }

  /** Whether a box lies apart from the one that a segment spans. */
  boolean apart(int i, double x1, double y1, double x2, double y2) {
    int at = SIDES * i;
    return Math.min(x1, x2) > sides[at + 2]
        || Math.max(x1, x2) < sides[at]
        || Math.min(y1, y2) > sides[at + 3]
        || Math.max(y1, y2) < sides[at + 1];
  }
}
