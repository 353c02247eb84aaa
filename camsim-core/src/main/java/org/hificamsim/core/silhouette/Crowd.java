package org.hificamsim.core.silhouette;

import java.util.Arrays;
import org.hificamsim.core.world.Targets;

/**
 * The targets around a camera, and for each of them the nearer ones in its direction. A sweep over
 * the directions in which targets begin finds them, so that no other targets are compared.
 */
final class Crowd {
  /** The sine below which an angle exceeds its sine by less than a hundredth. */
  private static final double SMALL = 0.1;

  private static final int BITS = 30;
  private static final double SCALE = (1 << BITS) / (2 * Math.PI);

  /** A margin that exceeds the rounding of a direction to a key, in radians. */
  private static final double MARGIN = 1e-8;

  private final Targets targets;

  /** The direction at which each target begins, and its number, in one value; ascending. */
  private final long[] keys;

  // by target

  private final double[] bearings;
  private final double[] halfAngles;
  private final double[] distances;

  // by rank in the order of the keys, so that the sweep reads memory in order

  private final double[] begins;
  private final double[] ends;
  private final double[] squared;
  private final int[] numbers;

  /** The targets that the sweep is passing, by rank, and where they end. */
  private final int[] active;

  private final double[] activeEnds;
  private final NearerTargets nearer;
  private double fromX;
  private double fromY;
  private int count;
  private int activeCount;

  Crowd(Targets targets) {
    this.targets = targets;
    int most = targets.count();
    keys = new long[most];
    bearings = new double[most];
    halfAngles = new double[most];
    distances = new double[most];
    begins = new double[most];
    ends = new double[most];
    squared = new double[most];
    numbers = new int[most];
    active = new int[most];
    activeEnds = new double[most];
    nearer = new NearerTargets(most);
  }

  /** Finds the targets around a point, and which of them overlap in its view. */
  void around(double x, double y) {
    fromX = x;
    fromY = y;
    count = 0;
    for (int target = 0; target < bearings.length; target++) {
      if (targets.present(target)) {
        place(target, targets.x(target) - x, targets.y(target) - y);
      }
    }
    Arrays.sort(keys, 0, count);
    for (int rank = 0; rank < count; rank++) {
      read(rank, (int) keys[rank]);
    }
    sweep();
  }

  /**
   * Adds a target in view, unless it contains the camera: then it hides nothing, and nothing hides
   * it.
   */
  private void place(int target, double dx, double dy) {
    double width = targets.width(target);
    double distance = dx * dx + dy * dy;
    if (distance > width * width / 4) {
      bearings[target] = Math.atan2(dy, dx);
      halfAngles[target] = halfAngle(width / 2 / Math.sqrt(distance));
      distances[target] = distance;
      keys[count++] = (long) ((begin(target) + Math.PI) * SCALE) << Integer.SIZE | target;
    }
  }

  /** Returns the angle within which a target hides others, rounded up. */
  private static double halfAngle(double sine) {
    return sine < SMALL ? 1.01 * sine : Math.asin(Math.min(1, sine)) + MARGIN;
  }

  private double begin(int target) {
    double begin = bearings[target] - halfAngles[target];
    return begin < -Math.PI ? begin + 2 * Math.PI : begin;
  }

  private void read(int rank, int target) {
    begins[rank] = begin(target);
    ends[rank] = begins[rank] + 2 * halfAngles[target];
    squared[rank] = distances[target];
    numbers[rank] = target;
  }

  private void sweep() {
    nearer.clear();
    activeCount = 0;
    for (int rank = 0; rank < count; rank++) {
      if (ends[rank] + MARGIN > Math.PI) {
        activate(rank, ends[rank] - 2 * Math.PI);
      }
    }
    for (int rank = 0; rank < count; rank++) {
      meetActive(rank, begins[rank] - MARGIN);
      activate(rank, ends[rank]);
    }
  }

  private void activate(int rank, double end) {
    active[activeCount] = rank;
    activeEnds[activeCount++] = end;
  }

  private void meetActive(int rank, double begin) {
    int kept = 0;
    for (int i = 0; i < activeCount; i++) {
      if (activeEnds[i] >= begin) {
        int other = active[i];
        active[kept] = other;
        activeEnds[kept++] = activeEnds[i];
        link(rank, other, squared[other] - squared[rank]);
      }
    }
    activeCount = kept;
  }

  /**
   * Links two targets, the nearer one in front. The sign is unpredictable, so its bit is read
   * instead of branching.
   */
  private void link(int rank, int other, double farther) {
    int rankIfNegative = (int) (Double.doubleToRawLongBits(farther) >> 63) & (rank ^ other);
    nearer.add(numbers[other ^ rankIfNegative], numbers[rank ^ rankIfNegative]);
  }

  double bearing(int target) {
    return bearings[target];
  }

  /** Puts the targets in front of the silhouette of one of them that may hide it. */
  void addTo(Silhouette silhouette, int target) {
    for (int link = nearer.first(target);
        link >= 0 && !silhouette.hidden();
        link = nearer.next(link)) {
      int other = nearer.target(link);
      silhouette.addTarget(
          targets.x(other) - fromX,
          targets.y(other) - fromY,
          targets.width(other),
          targets.height(other));
    }
  }
}
