package org.hificamsim.agents.cooperative;

import java.util.Arrays;

/**
 * The number of cameras that will detect the target of each slot of a forecast if all follow their
 * plans: the chances of at least 1, 2, ... cameras (a Poisson binomial distribution).
 */
final class PlannedCoverage {
  /** The chance above which one counts as 1, because removing it again would lose precision. */
  private static final double CERTAIN = 0.98;

  private final Worth worth;
  private final int maxCounted;
  private int[] certainCameras = {};

  /** The chances of at least 1, 2, ... cameras, apart from the certain ones, by slot. */
  private double[] atLeast = {};

  PlannedCoverage(Worth worth) {
    this.worth = worth;
    this.maxCounted = worth.saturation();
  }

  /** Removes all cameras, and sets the number of slots. */
  void clear(int slots) {
    if (certainCameras.length < slots) {
      certainCameras = new int[2 * slots];
      atLeast = new double[2 * slots * maxCounted];
    }
    Arrays.fill(certainCameras, 0, slots, 0);
    Arrays.fill(atLeast, 0, slots * maxCounted, 0);
  }

  /** Adds a camera that detects the target of a slot with this chance. */
  void add(int slot, double chance) {
    if (chance > CERTAIN) {
      certainCameras[slot]++;
      return;
    }
    int first = slot * maxCounted;
    for (int i = first + maxCounted - 1; i > first; i--) {
      atLeast[i] += chance * (atLeast[i - 1] - atLeast[i]);
    }
    atLeast[first] += chance * (1 - atLeast[first]);
  }

  /** Removes a camera that was added with this chance. */
  void remove(int slot, double chance) {
    if (chance > CERTAIN) {
      certainCameras[slot]--;
      return;
    }
    double oneFewer = 1;
    for (int i = slot * maxCounted; i < (slot + 1) * maxCounted; i++) {
      atLeast[i] = (atLeast[i] - chance * oneFewer) / (1 - chance);
      oneFewer = atLeast[i];
    }
  }

  /** The worth of one more camera that is certain to detect the target of a slot. */
  double added(int slot) {
    double sum = 0;
    for (int k = certainCameras[slot]; k < maxCounted; k++) {
      sum += worth.added(k) * (atLeast(slot, k) - atLeast(slot, k + 1));
    }
    return sum;
  }

  /** The chance that any camera detects the target of a slot. */
  double covered(int slot) {
    return atLeast(slot, 1);
  }

  /** The worth of a target that k cameras detect. */
  double worth(int k) {
    double sum = 0;
    for (int i = 0; i < Math.min(k, maxCounted); i++) {
      sum += worth.added(i);
    }
    return sum;
  }

  private double atLeast(int slot, int k) {
    return k <= certainCameras[slot]
        ? 1
        : atLeast[slot * maxCounted + k - certainCameras[slot] - 1];
  }
}
