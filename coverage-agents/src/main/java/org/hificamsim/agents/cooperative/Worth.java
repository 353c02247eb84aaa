package org.hificamsim.agents.cooperative;

import org.hificamsim.core.metrics.Objective;

/**
 * What a target is worth that k cameras detect: a stand-in for an objective that is a sum over
 * targets, which cameras can divide among them. What a camera more adds is the objective's {@link
 * Objective#share share}. Where a target needs several cameras to count, those before the last one
 * add a part in advance; where the least k counts, it is a harmonic sum.
 */
final class Worth {
  private static final int MOST = 4;

  private final double[] added;

  /**
   * @param lead what a target is worth with one camera less than it needs, where it needs several
   */
  Worth(Objective objective, double lead) {
    int needed = 1;
    while (needed < Integer.MAX_VALUE && objective.share(needed) == 0) {
      needed++;
    }
    int last = needed;
    while (last < MOST && objective.share(last + 1) > 0) {
      last++;
    }
    added = new double[last];
    for (int k = 1; k <= last; k++) {
      boolean enough = k > needed || needed == 1;
      double before = lead / Math.max(1, needed - 1);
      added[k - 1] = enough ? objective.share(k) : k < needed ? before : 1 - lead;
    }
  }

  /** From this number of cameras on another one adds nothing. */
  int most() {
    return added.length;
  }

  /** What a camera adds for a target that k others detect, k below {@link #most}. */
  double added(int k) {
    return added[k];
  }
}
