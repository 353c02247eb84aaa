package org.hificamsim.core.metrics;

import java.util.Arrays;

/**
 * The chances of all pairs of a camera and a target, sorted by target; grows, and is used again.
 */
final class PairsByTarget {
  private int[] who = {};
  private double[] chances = {};
  private int[] targetOf = new int[16];
  private double[] chanceOf = new double[16];
  private double[] sorted = new double[16];
  private int[] ends = {};

  void collect(DetectionChances observed) {
    int targets = observed.targets();
    if (who.length < targets) {
      who = new int[targets];
      chances = new double[targets];
      ends = new int[targets + 1];
    }
    int count = 0;
    for (int camera = 0; camera < observed.cameras(); camera++) {
      int some = observed.chances(camera, who, chances);
      makeRoom(count + some);
      System.arraycopy(who, 0, targetOf, count, some);
      System.arraycopy(chances, 0, chanceOf, count, some);
      count += some;
    }
    sort(count);
  }

  private void makeRoom(int pairs) {
    if (pairs > targetOf.length) {
      targetOf = Arrays.copyOf(targetOf, 2 * pairs);
      chanceOf = Arrays.copyOf(chanceOf, 2 * pairs);
      sorted = new double[2 * pairs];
    }
  }

  /** A counting sort; a target's entry in {@code ends} rises from its first pair to its end. */
  private void sort(int count) {
    Arrays.fill(ends, 0);
    for (int i = 0; i < count; i++) {
      ends[targetOf[i] + 1]++;
    }
    for (int target = 1; target < ends.length; target++) {
      ends[target] += ends[target - 1];
    }
    for (int i = 0; i < count; i++) {
      sorted[ends[targetOf[i]]++] = chanceOf[i];
    }
  }

  private int first(int target) {
    return target == 0 ? 0 : ends[target - 1];
  }

  /** The number of cameras that may cover a target. */
  int count(int target) {
    return ends[target] - first(target);
  }

  /**
   * How many of them cover it.
   *
   * @param most as {@link PoissonBinomial#set} has it
   */
  void cover(int target, int most, PoissonBinomial covering) {
    covering.set(sorted, first(target), ends[target], most);
  }

  /** The expected number of them. */
  double mean(int target) {
    double sum = 0;
    for (int i = first(target); i < ends[target]; i++) {
      sum += sorted[i];
    }
    return sum;
  }
}
