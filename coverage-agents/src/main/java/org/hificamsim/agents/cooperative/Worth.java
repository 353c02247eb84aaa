package org.hificamsim.agents.cooperative;

import java.util.Arrays;
import org.hificamsim.core.metrics.Objective;

/**
 * The worth of a target that k cameras detect. It stands in for the objective by a sum over
 * targets, which cameras can divide among themselves. A further camera adds the objective's {@link
 * Objective#share share}. If a target needs several cameras to count, those before the last one add
 * a part in advance. If the least k counts, each further camera is worth a part of the one before,
 * so that targets which few cameras detect come first.
 */
final class Worth {
  /** The greatest number of cameras that count, unless a target needs more. */
  private static final int MAX_COUNTED = 4;

  /** The worth of one more camera, by the number of cameras that detect the target without it. */
  private final double[] added;

  /**
   * @param lead the worth of a target that lacks one camera, if it needs several
   * @param further the worth of a camera as a share of the previous camera's worth, if the least k
   *     counts
   */
  Worth(Objective objective, double lead, double further) {
    added = objective.isLeast() ? decreasing(further) : shares(objective, lead);
  }

  private static double[] decreasing(double further) {
    double[] added = new double[MAX_COUNTED];
    Arrays.setAll(added, k -> Math.pow(further, k));
    return added;
  }

  private static double[] shares(Objective objective, double lead) {
    int needed = 1;
    while (needed < Integer.MAX_VALUE && objective.share(needed) == 0) {
      needed++;
    }
    int last = needed;
    while (last < MAX_COUNTED && objective.share(last + 1) > 0) {
      last++;
    }
    double[] added = new double[last];
    // If several are needed, they share a worth of 1: the last one 1 - lead, those before it lead.
    for (int k = 1; k <= last; k++) {
      boolean enough = k > needed || needed == 1;
      double before = lead / Math.max(1, needed - 1);
      added[k - 1] = enough ? objective.share(k) : k < needed ? before : 1 - lead;
    }
    return added;
  }

  /** The least number of cameras after which a further one adds nothing. */
  int saturation() {
    return added.length;
  }

  /** The worth of a camera for a target that k others detect, with k below {@link #saturation}. */
  double added(int k) {
    return added[k];
  }
}
