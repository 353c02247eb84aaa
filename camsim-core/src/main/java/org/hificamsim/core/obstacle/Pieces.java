package org.hificamsim.core.obstacle;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

/**
 * The pieces of obstacles that a line of sight from outside can meet: the edges of walls and
 * polygons, and pillars; in flat arrays, in the order of the obstacles.
 */
final class Pieces {
  /** The x coordinate of an end of each edge, or of the centre of each pillar, by piece. */
  final double[] x1;

  final double[] y1;

  /** The x coordinate of the other end of each edge, or of the centre of each pillar, by piece. */
  final double[] x2;

  final double[] y2;

  /** The radius of each pillar, by piece; 0 for an edge. */
  final double[] radius;

  /** The number of each piece's obstacle. */
  final int[] obstacle;

  /** The share of the light that passes each obstacle, from 0 to 1. */
  final double[] transmittance;

  /** Whether each obstacle reaches from the ground to any height. */
  final boolean[] full;

  /** The first piece of each obstacle; the last entry is the number of pieces. */
  final int[] first;

  /**
   * The bounding box of each obstacle: least x, least y, greatest x, greatest y, rounded outwards.
   */
  private final double[][] boxes;

  Pieces(List<Obstacle> obstacles) {
    List<double[]> pieces = new ArrayList<>();
    transmittance = obstacles.stream().mapToDouble(Obstacle::transmittance).toArray();
    full = new boolean[obstacles.size()];
    first = new int[obstacles.size() + 1];
    for (int i = 0; i < obstacles.size(); i++) {
      add(obstacles.get(i), pieces);
      full[i] = obstacles.get(i).full();
      first[i + 1] = pieces.size();
    }
    x1 = column(pieces, 0);
    y1 = column(pieces, 1);
    x2 = column(pieces, 2);
    y2 = column(pieces, 3);
    radius = column(pieces, 4);
    obstacle = owners();
    boxes = IntStream.range(0, obstacles.size()).mapToObj(this::box).toArray(double[][]::new);
  }

  private double[] box(int obstacle) {
    double[] box = {Double.MAX_VALUE, Double.MAX_VALUE, -Double.MAX_VALUE, -Double.MAX_VALUE};
    for (int i = first[obstacle]; i < first[obstacle + 1]; i++) {
      box[0] = Math.min(box[0], Math.nextDown(Math.min(x1[i], x2[i]) - radius[i]));
      box[1] = Math.min(box[1], Math.nextDown(Math.min(y1[i], y2[i]) - radius[i]));
      box[2] = Math.max(box[2], Math.nextUp(Math.max(x1[i], x2[i]) + radius[i]));
      box[3] = Math.max(box[3], Math.nextUp(Math.max(y1[i], y2[i]) + radius[i]));
    }
    return box;
  }

  /**
   * Whether the bounding boxes of an obstacle and of a segment are disjoint. This quickly excludes
   * most obstacles; without it, segments in line with a distant wall would be decided by decimals,
   * which allocate.
   */
  boolean isApart(int obstacle, double ax, double ay, double bx, double by) {
    double[] box = boxes[obstacle];
    return Math.min(ax, bx) > box[2]
        || Math.max(ax, bx) < box[0]
        || Math.min(ay, by) > box[3]
        || Math.max(ay, by) < box[1];
  }

  private static void add(Obstacle obstacle, List<double[]> pieces) {
    if (obstacle instanceof Obstacle.Wall wall) {
      pieces.add(new double[] {wall.x1(), wall.y1(), wall.x2(), wall.y2(), 0});
    } else if (obstacle instanceof Obstacle.Pillar pillar) {
      double x = pillar.x();
      double y = pillar.y();
      pieces.add(new double[] {x, y, x, y, pillar.radius()});
    } else if (obstacle instanceof Obstacle.Polygon polygon) {
      Point from = polygon.points().get(polygon.points().size() - 1);
      for (Point to : polygon.points()) {
        pieces.add(new double[] {from.x(), from.y(), to.x(), to.y(), 0});
        from = to;
      }
    }
  }

  private static double[] column(List<double[]> pieces, int column) {
    return pieces.stream().mapToDouble(piece -> piece[column]).toArray();
  }

  private int[] owners() {
    int[] owners = new int[x1.length];
    for (int i = 0; i + 1 < first.length; i++) {
      Arrays.fill(owners, first[i], first[i + 1], i);
    }
    return owners;
  }

  int count() {
    return x1.length;
  }

  /** Whether the piece hides everything behind it, at any height. */
  boolean hides(int piece) {
    return transmittance[obstacle[piece]] == 0 && full[obstacle[piece]];
  }

  /** Whether a closed segment touches a piece; the inside of a polygon is no part of its edges. */
  boolean touches(int piece, double ax, double ay, double bx, double by) {
    return radius[piece] > 0
        ? Discs.touch(x1[piece], y1[piece], radius[piece], ax, ay, bx, by)
        : Segments.touch(ax, ay, bx, by, x1[piece], y1[piece], x2[piece], y2[piece]);
  }
}
