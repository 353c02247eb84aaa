package org.hificamsim.core.metrics;

import java.util.Arrays;

/** How many of several independent trials succeed, each with a chance of its own; used again. */
final class PoissonBinomial {
  private double[] exactly = new double[8];
  private double[] atLeast = new double[9];
  private int trials;

  /** Takes the chances from index {@code from} up to {@code to}, each in [0, 1]. */
  void set(double[] chances, int from, int to) {
    makeRoom(to - from + 1);
    trials = 0;
    exactly[0] = 1;
    for (int i = from; i < to; i++) {
      add(chances[i]);
    }
    atLeast[trials + 1] = 0;
    for (int k = trials; k >= 0; k--) {
      atLeast[k] = Math.min(1, atLeast[k + 1] + exactly[k]);
    }
  }

  private void add(double chance) {
    trials++;
    exactly[trials] = exactly[trials - 1] * chance;
    for (int k = trials - 1; k > 0; k--) {
      exactly[k] = exactly[k] * (1 - chance) + exactly[k - 1] * chance;
    }
    exactly[0] *= 1 - chance;
  }

  private void makeRoom(int counts) {
    if (counts > exactly.length) {
      exactly = Arrays.copyOf(exactly, 2 * counts);
      atLeast = Arrays.copyOf(atLeast, 2 * counts + 1);
    }
  }

  /** The number of trials. */
  int trials() {
    return trials;
  }

  /**
   * The chance of this many successes or more, in [0, 1].
   *
   * @param successes 0 or more
   */
  double atLeast(int successes) {
    return successes > trials ? 0 : atLeast[successes];
  }
}
