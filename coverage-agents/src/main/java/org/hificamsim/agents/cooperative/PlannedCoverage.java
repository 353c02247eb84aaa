package org.hificamsim.agents.cooperative;

import java.util.Arrays;

/**
 * How many cameras are going to detect each target at each place that it may be at, a slot, if all
 * do as planned: the chances that it is 1, 2, ... or more (a Poisson binomial distribution).
 */
final class PlannedCoverage {
  /** Above this a detection is taken for certain: what was added can be removed without loss. */
  private static final double CERTAIN = 0.98;

  private final Worth worth;
  private final int most;
  private int[] certain = {};
  private double[] atLeast = {}; // of the others: by slot, the chance of 1, 2, ... or more

  PlannedCoverage(Worth worth) {
    this.worth = worth;
    this.most = worth.most();
  }

  /** Nobody covers anything. */
  void clear(int slots) {
    if (certain.length < slots) {
      certain = new int[2 * slots];
      atLeast = new double[2 * slots * most];
    }
    Arrays.fill(certain, 0, slots, 0);
    Arrays.fill(atLeast, 0, slots * most, 0);
  }

  /** A camera more that detects what is in a slot with a chance. */
  void add(int slot, double chance) {
    if (chance > CERTAIN) {
      certain[slot]++;
      return;
    }
    int first = slot * most;
    for (int i = first + most - 1; i > first; i--) {
      atLeast[i] += chance * (atLeast[i - 1] - atLeast[i]);
    }
    atLeast[first] += chance * (1 - atLeast[first]);
  }

  /** Takes back what was added. */
  void remove(int slot, double chance) {
    if (chance > CERTAIN) {
      certain[slot]--;
      return;
    }
    double before = 1;
    for (int i = slot * most; i < (slot + 1) * most; i++) {
      atLeast[i] = (atLeast[i] - chance * before) / (1 - chance);
      before = atLeast[i];
    }
  }

  /** What a camera more adds in a slot that is certain to detect what is there. */
  double added(int slot) {
    double sum = 0;
    for (int k = certain[slot]; k < most; k++) {
      sum += worth.added(k) * (atLeast(slot, k) - atLeast(slot, k + 1));
    }
    return sum;
  }

  /** What a target is worth that k cameras detect. */
  double worth(int k) {
    double sum = 0;
    for (int i = 0; i < Math.min(k, most); i++) {
      sum += worth.added(i);
    }
    return sum;
  }

  private double atLeast(int slot, int k) {
    return k <= certain[slot] ? 1 : atLeast[slot * most + k - certain[slot] - 1];
  }
}
