package org.hificamsim.core.silhouette;

import java.util.Arrays;
import org.hificamsim.core.world.Targets;

/**
 * The targets around a camera in the order of their bearings, so that only neighbours are compared.
 * Those that fill a wide angle, since they are close, are kept apart.
 */
final class Crowd {
  private static final double WIDE = 0.15;
  private static final int BITS = 30;
  private static final double SCALE = (1 << BITS) / (2 * Math.PI);

  /** More than the rounding of a bearing to a key. */
  private static final double MARGIN = 1e-8;

  private final Targets targets;

  /** A bearing and the number of its target, ascending. */
  private final long[] keys;

  private final double[] bearings;
  private final int[] ranks;
  private final int[] wide;
  private int count;
  private int wideCount;
  private double greatestHalf;

  Crowd(Targets targets) {
    this.targets = targets;
    keys = new long[targets.count()];
    bearings = new double[targets.count()];
    ranks = new int[targets.count()];
    wide = new int[targets.count()];
  }

  /** Sorts the targets that are present around a point. */
  void around(double x, double y) {
    count = 0;
    wideCount = 0;
    greatestHalf = 0;
    for (int target = 0; target < bearings.length; target++) {
      if (targets.present(target)) {
        add(target, targets.x(target) - x, targets.y(target) - y);
      }
    }
    Arrays.sort(keys, 0, count);
    for (int rank = 0; rank < count; rank++) {
      ranks[(int) keys[rank]] = rank;
    }
  }

  private void add(int target, double dx, double dy) {
    double bearing = Math.atan2(dy, dx);
    if (Double.isNaN(bearing)) {
      return;
    }
    bearings[target] = bearing;
    keys[count++] = (long) ((bearing + Math.PI) * SCALE) << Integer.SIZE | target;
    double half = targets.width(target) / 2 / Math.sqrt(dx * dx + dy * dy);
    if (half < WIDE) {
      greatestHalf = Math.max(greatestHalf, half);
    } else {
      wide[wideCount++] = target;
    }
  }

  double bearing(int target) {
    return bearings[target];
  }

  /** Puts the targets in front of the silhouette of one of them that may hide it. */
  void addTo(Silhouette silhouette, int target) {
    for (int i = 0; i < wideCount && !silhouette.hidden(); i++) {
      if (wide[i] != target) {
        add(silhouette, wide[i]);
      }
    }
    // the arc sine of an angle below WIDE exceeds it by less than a hundredth
    double window = silhouette.halfAngle() + 1.01 * greatestHalf + MARGIN;
    int around = scan(silhouette, target, window, 1, count - 1);
    scan(silhouette, target, window, -1, count - 1 - around);
  }

  private int scan(Silhouette silhouette, int target, double window, int way, int most) {
    for (int i = 1; i <= most; i++) {
      int other = (int) keys[Math.floorMod(ranks[target] + way * i, count)];
      double off = way * (bearings[other] - bearings[target]);
      if ((off < -MARGIN ? off + 2 * Math.PI : off) > window || silhouette.hidden()) {
        return i - 1;
      }
      add(silhouette, other);
    }
    return most;
  }

  private void add(Silhouette silhouette, int other) {
    silhouette.addTarget(
        targets.x(other), targets.y(other), targets.width(other), targets.height(other));
  }
}
