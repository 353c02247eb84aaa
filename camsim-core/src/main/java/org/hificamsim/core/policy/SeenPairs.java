package org.hificamsim.core.policy;

import java.util.Arrays;

/**
 * Pairs of a camera and a target that it sees, in the order of cameras; see {@link
 * NetworkView#findSeen}. Keeps its arrays from one step to the next.
 */
public final class SeenPairs {
  private static final int FIRST_PAIRS = 16;

  private long[] found = {};
  private int[] cameras = {};
  private int[] targets = {};
  private double[] ahead = {};
  private double[] right = {};
  private double[] squared = {};
  private int count;

  /** Forgets all pairs. */
  public void clear() {
    count = 0;
  }

  /**
   * Adds a pair.
   *
   * @param newAhead metres from the camera along the axis of its view
   * @param newRight metres to the right of that axis
   */
  public void add(int camera, int target, double newAhead, double newRight) {
    if (count == cameras.length) {
      grow(Math.max(FIRST_PAIRS, 2 * count));
    }
    cameras[count] = camera;
    targets[count] = target;
    ahead[count] = newAhead;
    right[count] = newRight;
    squared[count] = newAhead * newAhead + newRight * newRight;
    count++;
  }

  private void grow(int pairs) {
    cameras = Arrays.copyOf(cameras, pairs);
    targets = Arrays.copyOf(targets, pairs);
    ahead = Arrays.copyOf(ahead, pairs);
    right = Arrays.copyOf(right, pairs);
    squared = Arrays.copyOf(squared, pairs);
  }

  /**
   * Brings each camera's nearest targets to the front, the nearest first; of equally near ones the
   * lower number.
   *
   * @param wanted how many of each camera; the others are in no order
   */
  public void sort(int wanted) {
    for (int i = 1; i < count; i++) {
      if (cameras[i] == cameras[i - 1]) { // most cameras see one target at most
        i = sort(i - 1, wanted);
      }
    }
  }

  /** Sorts the pairs of one camera; returns where those of the next one begin. */
  private int sort(int from, int wanted) {
    int to = from + 2;
    while (to < count && cameras[to] == cameras[from]) {
      to++;
    }
    for (int at = from; at < Math.min(to - 1, from + wanted); at++) {
      bringNearest(at, to);
    }
    return to;
  }

  private void bringNearest(int at, int end) {
    int nearest = at;
    for (int i = at + 1; i < end; i++) {
      nearest = isBefore(i, nearest) ? i : nearest;
    }
    if (nearest != at) {
      swap(at, nearest);
    }
  }

  private boolean isBefore(int one, int other) {
    return squared[one] < squared[other]
        || (squared[one] == squared[other] && targets[one] < targets[other]);
  }

  private void swap(int one, int other) {
    int target = targets[one];
    targets[one] = targets[other];
    targets[other] = target;
    swap(ahead, one, other);
    swap(right, one, other);
    swap(squared, one, other);
  }

  private static void swap(double[] of, int one, int other) {
    double kept = of[one];
    of[one] = of[other];
    of[other] = kept;
  }

  /**
   * Memory for finding the pairs, with what was left in it.
   *
   * @param entries how many it must have
   */
  public long[] scratch(int entries) {
    if (entries > found.length) {
      found = Arrays.copyOf(found, Math.max(entries, 2 * found.length));
    }
    return found;
  }

  /** How many pairs there are. */
  public int count() {
    return count;
  }

  /** The camera of a pair. */
  public int camera(int pair) {
    return cameras[pair];
  }

  /** The target that it sees. */
  public int target(int pair) {
    return targets[pair];
  }

  /** How far the target is from the camera along the axis of its view, metres. */
  public double ahead(int pair) {
    return ahead[pair];
  }

  /** How far it is to the right of that axis, metres. */
  public double right(int pair) {
    return right[pair];
  }

  /** The distance of the two, metres. */
  public double distance(int pair) {
    return Math.sqrt(squared[pair]);
  }
}
