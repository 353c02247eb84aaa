package org.hificamsim.core.silhouette;

import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Point;

/** The solid pieces of obstacles: the edges of walls and polygons, and pillars. */
final class Walls {
  private record Piece(
      double x1, double y1, double x2, double y2, double radius, double base, double height) {}

  private final Piece[] pieces;

  Walls(List<Obstacle> obstacles) {
    List<Piece> found = new ArrayList<>();
    obstacles.stream().filter(Obstacle::solid).forEach(obstacle -> add(obstacle, found));
    pieces = found.toArray(Piece[]::new);
  }

  private static void add(Obstacle obstacle, List<Piece> pieces) {
    double base = obstacle.base();
    double height = obstacle.height();
    if (obstacle instanceof Obstacle.Wall wall) {
      pieces.add(new Piece(wall.x1(), wall.y1(), wall.x2(), wall.y2(), 0, base, height));
    } else if (obstacle instanceof Obstacle.Pillar pillar) {
      double x = pillar.x();
      double y = pillar.y();
      pieces.add(new Piece(x, y, x, y, pillar.radius(), base, height));
    } else if (obstacle instanceof Obstacle.Polygon polygon) {
      Point from = polygon.points().get(polygon.points().size() - 1);
      for (Point to : polygon.points()) {
        pieces.add(new Piece(from.x(), from.y(), to.x(), to.y(), 0, base, height));
        from = to;
      }
    }
  }

  /** Whether the piece reaches from the ground to any height. */
  boolean isFull(int piece) {
    return pieces[piece].base == 0 && pieces[piece].height == Double.POSITIVE_INFINITY;
  }

  int count() {
    return pieces.length;
  }

  /** Returns the x coordinate of an end of an edge, or of the middle of a pillar, in metres. */
  double x1(int piece) {
    return pieces[piece].x1;
  }

  double y1(int piece) {
    return pieces[piece].y1;
  }

  /** The other end of an edge, or the middle of a pillar, in metres. */
  double x2(int piece) {
    return pieces[piece].x2;
  }

  double y2(int piece) {
    return pieces[piece].y2;
  }

  /** The radius of a pillar, in metres; 0 for an edge. */
  double radius(int piece) {
    return pieces[piece].radius;
  }

  /** The height of the underside, in metres. */
  double base(int piece) {
    return pieces[piece].base;
  }

  /** The height of the top, in metres; may be infinite. */
  double height(int piece) {
    return pieces[piece].height;
  }
}
