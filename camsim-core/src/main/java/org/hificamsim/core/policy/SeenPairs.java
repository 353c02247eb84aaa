package org.hificamsim.core.policy;

import java.util.Arrays;

/**
 * The pairs of a camera and a target that it sees, in the order of cameras; see {@link
 * NetworkView#findSeen}. Reuse one for all steps: it keeps its arrays.
 */
public final class SeenPairs {
  private static final int INITIAL_PAIRS = 16;

  private long[] found = {};
  private int[] cameras = {};
  private int[] targets = {};
  private double[] ahead = {};
  private double[] right = {};
  private double[] squared = {};
  private int count;

  /** Removes all pairs. */
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
      grow(Math.max(INITIAL_PAIRS, 2 * count));
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
   * Sorts the nearest targets of each camera to the front of its pairs; equally near ones by
   * number.
   *
   * @param nearest the number of targets that are sorted; the others are in no order
   */
  public void sort(int nearest) {
    for (int i = 1; i < count; i++) {
      // Most cameras see one target at most.
      if (cameras[i] == cameras[i - 1]) {
        i = sort(i - 1, nearest);
      }
    }
  }

  /** Sorts the pairs of one camera; returns the index of the next camera's first pair. */
  private int sort(int from, int nearest) {
    int to = from + 2;
    while (to < count && cameras[to] == cameras[from]) {
      to++;
    }
    for (int index = from; index < Math.min(to - 1, from + nearest); index++) {
      bringNearest(index, to);
    }
    return to;
  }

  private void bringNearest(int index, int end) {
    int nearest = index;
    for (int i = index + 1; i < end; i++) {
      nearest = isBefore(i, nearest) ? i : nearest;
    }
    if (nearest != index) {
      swap(index, nearest);
    }
  }

  private boolean isBefore(int pair, int other) {
    return squared[pair] < squared[other]
        || (squared[pair] == squared[other] && targets[pair] < targets[other]);
  }

  private void swap(int pair, int other) {
    int target = targets[pair];
    targets[pair] = targets[other];
    targets[other] = target;
    swap(ahead, pair, other);
    swap(right, pair, other);
    swap(squared, pair, other);
  }

  private static void swap(double[] values, int pair, int other) {
    double value = values[pair];
    values[pair] = values[other];
    values[other] = value;
  }

  /**
   * Returns scratch memory for finding pairs; its content is undefined.
   *
   * @param entries the least number of entries
   */
  public long[] scratch(int entries) {
    if (entries > found.length) {
      found = Arrays.copyOf(found, Math.max(entries, 2 * found.length));
    }
    return found;
  }

  /** The number of pairs. */
  public int count() {
    return count;
  }

  /** The camera of a pair. */
  public int camera(int pair) {
    return cameras[pair];
  }

  /** The target of a pair. */
  public int target(int pair) {
    return targets[pair];
  }

  /** The distance of a pair's target ahead of the camera along the axis of its view, in metres. */
  public double ahead(int pair) {
    return ahead[pair];
  }

  /** The distance of a pair's target to the right of that axis, in metres. */
  public double right(int pair) {
    return right[pair];
  }

  /** The distance between camera and target of a pair, in metres. */
  public double distance(int pair) {
    return Math.sqrt(squared[pair]);
  }
}
