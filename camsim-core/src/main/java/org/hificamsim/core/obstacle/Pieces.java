package org.hificamsim.core.obstacle;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Obstacles as what a line of sight from outside meets of them: the edges of walls and polygons,
 * and pillars, in flat arrays, in the order of obstacles.
 */
final class Pieces {
  /** One end of an edge, or a pillar's centre. */
  final double[] x1;

  final double[] y1;

  /** The other end of an edge. */
  final double[] x2;

  final double[] y2;

  /** 0 of an edge. */
  final double[] radius;

  /** The number of its obstacle. */
  final int[] obstacle;

  /** By obstacle. */
  final double[] transmittance;

  /** By obstacle: its first piece; one more is their number. */
  final int[] first;

  Pieces(List<Obstacle> obstacles) {
    List<double[]> pieces = new ArrayList<>();
    transmittance = obstacles.stream().mapToDouble(Obstacle::transmittance).toArray();
    first = new int[obstacles.size() + 1];
    for (int i = 0; i < obstacles.size(); i++) {
      add(obstacles.get(i), pieces);
      first[i + 1] = pieces.size();
    }
    x1 = column(pieces, 0);
    y1 = column(pieces, 1);
    x2 = column(pieces, 2);
    y2 = column(pieces, 3);
    radius = column(pieces, 4);
    obstacle = owners();
  }

  private static void add(Obstacle obstacle, List<double[]> pieces) {
    if (obstacle instanceof Obstacle.Wall wall) {
      pieces.add(new double[] {wall.x1(), wall.y1(), wall.x2(), wall.y2(), 0});
    } else if (obstacle instanceof Obstacle.Pillar pillar) {
      pieces.add(new double[] {pillar.x(), pillar.y(), 0, 0, pillar.radius()});
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

  boolean solid(int piece) {
    return transmittance[obstacle[piece]] == 0;
  }

  /** Whether a closed segment has a point of a piece; of a polygon's edge, not of its inside. */
  boolean touches(int piece, double ax, double ay, double bx, double by) {
    return radius[piece] > 0
        ? Discs.touch(x1[piece], y1[piece], radius[piece], ax, ay, bx, by)
        : Segments.touch(ax, ay, bx, by, x1[piece], y1[piece], x2[piece], y2[piece]);
  }
}
