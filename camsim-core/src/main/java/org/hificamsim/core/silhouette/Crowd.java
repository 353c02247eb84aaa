package org.hificamsim.core.silhouette;

import java.util.Arrays;
import org.hificamsim.core.world.Targets;

/**
 * The targets around a camera in the order of their bearings, so that only neighbours are compared.
 * Those that fill a wide angle, since they are close, are kept apart.
 */
final class Crowd {
  private static final double WIDE = 0.1;
  private static final int BITS = 30;
  private static final double SCALE = (1 << BITS) / (2 * Math.PI);

  /** More than the rounding of a bearing to a key. */
  private static final double MARGIN = 1e-8;

  private final Targets targets;

  /** A bearing and the number of its target, ascending. */
  private final long[] keys;

  /** By target. */
  private final int[] ranks;

  private final double[] bearings;

  // by rank, so that neighbours are next to each other in memory

  private final double[] dx;
  private final double[] dy;
  private final double[] width;
  private final double[] height;
  private final double[] bearing;

  private final int[] wide;
  private int count;
  private int wideCount;
  private double greatestHalf;

  Crowd(Targets targets) {
    this.targets = targets;
    int most = targets.count();
    keys = new long[most];
    ranks = new int[most];
    bearings = new double[most];
    dx = new double[most];
    dy = new double[most];
    width = new double[most];
    height = new double[most];
    bearing = new double[most];
    wide = new int[most];
  }

  /** Sorts the targets that are present around a point. */
  void around(double x, double y) {
    count = 0;
    for (int target = 0; target < bearings.length; target++) {
      double direction = Math.atan2(targets.y(target) - y, targets.x(target) - x);
      bearings[target] = direction;
      if (targets.present(target) && !Double.isNaN(direction)) {
        keys[count++] = (long) ((direction + Math.PI) * SCALE) << Integer.SIZE | target;
      }
    }
    Arrays.sort(keys, 0, count);
    wideCount = 0;
    greatestHalf = 0;
    for (int rank = 0; rank < count; rank++) {
      read(rank, (int) keys[rank], x, y);
    }
  }

  private void read(int rank, int target, double x, double y) {
    ranks[target] = rank;
    bearing[rank] = bearings[target];
    dx[rank] = targets.x(target) - x;
    dy[rank] = targets.y(target) - y;
    width[rank] = targets.width(target);
    height[rank] = targets.height(target);
    double half = width[rank] / 2 / Math.sqrt(dx[rank] * dx[rank] + dy[rank] * dy[rank]);
    if (half < WIDE) {
      greatestHalf = Math.max(greatestHalf, half);
    } else {
      wide[wideCount++] = rank;
    }
  }

  double bearing(int target) {
    return bearings[target];
  }

  /** Puts the targets in front of the silhouette of one of them that may hide it. */
  void addTo(Silhouette silhouette, int target) {
    int rank = ranks[target];
    for (int i = 0; i < wideCount && !silhouette.hidden(); i++) {
      add(silhouette, wide[i], rank);
    }
    // the arc sine of a number below WIDE exceeds it by less than a hundredth
    double window = silhouette.halfAngle() + 1.01 * greatestHalf + MARGIN;
    int before = scan(silhouette, rank, window, 1, count - 1);
    scan(silhouette, rank, window, -1, count - 1 - before);
  }

  /** Scans neighbours to one side; returns how many there are within the window. */
  private int scan(Silhouette silhouette, int rank, double window, int way, int most) {
    int other = rank;
    for (int i = 0; i < most; i++) {
      other += way;
      other = other == count ? 0 : other < 0 ? count - 1 : other;
      double off = way * (bearing[other] - bearing[rank]);
      if ((off < -MARGIN ? off + 2 * Math.PI : off) > window || silhouette.hidden()) {
        return i;
      }
      add(silhouette, other, rank);
    }
    return most;
  }

  private void add(Silhouette silhouette, int other, int rank) {
    if (other != rank) {
      silhouette.addTarget(dx[other], dy[other], width[other], height[other]);
    }
  }
}
