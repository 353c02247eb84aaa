package org.hificamsim.core.metrics;

import java.util.Arrays;

/** How many of several independent trials succeed, each with a chance of its own; used again. */
final class PoissonBinomial {
  private double[] exactly = new double[8];
  private double[] atLeast = new double[9];
  private int most;

  /**
   * Takes the chances from index {@code from} up to {@code to}, each in [0, 1].
   *
   * @param most successes that are counted exactly; what is beyond counts as that number
   */
  void set(double[] chances, int from, int to, int most) {
    this.most = Math.min(most, to - from);
    makeRoom(this.most + 1);
    Arrays.fill(exactly, 0, this.most + 1, 0);
    exactly[0] = 1;
    for (int i = from; i < to; i++) {
      add(chances[i]);
    }
    atLeast[this.most + 1] = 0;
    for (int k = this.most; k >= 0; k--) {
      atLeast[k] = Math.min(1, atLeast[k + 1] + exactly[k]);
    }
  }

  /** The last count keeps what it has, and gains from the one before it. */
  private void add(double chance) {
    if (most == 0) {
      return;
    }
    exactly[most] += exactly[most - 1] * chance;
    for (int k = most - 1; k > 0; k--) {
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

  /**
   * The chance of this many successes or more, in [0, 1].
   *
   * @param successes 0 or more; of more than are counted it is 0
   */
  double atLeast(int successes) {
    return successes > most ? 0 : atLeast[successes];
  }
}
