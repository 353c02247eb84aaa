package org.hificamsim.agents.choice;

import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.registry.Options;

/**
 * Computes the utility of an observation for a camera: the number of targets that it detects (U_i
 * of Eq 7.3), or its difference reward (Wolpert and Tumer, 2002), which is what the score would
 * lose without it.
 *
 * <p>For the difference, a camera needs to know how many cameras detect each of its targets, from
 * its neighbours' reports. For {@code covered:k} the difference is the number of its targets that
 * exactly k cameras detect; for {@code sum:cap}, the number of those that at most cap cameras
 * detect. Under {@code lexicographic} and {@code kmin} the score depends on one target that a
 * camera may never see. There each target counts 1/k, the difference of a harmonic sum, so that
 * targets which few cameras detect count most.
 */
public final class Utility {
  /** The values of the option {@code utility}. */
  public enum Reading {
    /** The count under kmin, as in the thesis; the difference under any other objective. */
    OBJECTIVE,
    COUNT,
    DIFFERENCE
  }

  private final Objective objective;
  private final boolean isCount;

  public Utility(Reading reading, Objective objective) {
    this.objective = objective;
    this.isCount =
        reading == Reading.COUNT || (reading == Reading.OBJECTIVE && objective.rewardsCount());
  }

  /** Reads the option {@code utility}. */
  public static Reading from(Options options) {
    return options.choice(
        "utility",
        Reading.OBJECTIVE,
        "what is rewarded: count, difference (what the score would lose without the camera),"
            + " objective (count under kmin, difference else)");
  }

  /** Whether the utility is the number of detected targets. */
  public boolean isCount() {
    return isCount;
  }

  /** Returns a camera's utility in the present observation; 0 while it is offline. */
  public double compute(NetworkView network, int camera) {
    int detected = network.detected(camera);
    return isCount || detected == 0 ? detected : difference(network, camera);
  }

  private double difference(NetworkView network, int camera) {
    double sum = 0;
    for (int target = 0; target < network.targets(); target++) {
      if (network.coverage(target) > 0 && network.sees(camera, target)) {
        sum += objective.share(network.coverage(target));
      }
    }
    return sum;
  }
}
