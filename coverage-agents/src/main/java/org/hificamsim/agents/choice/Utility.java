package org.hificamsim.agents.choice;

import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.registry.Options;

/**
 * What a camera makes of an observation: the number of targets that it detects (U_i of Eq 7.3), or
 * its difference reward (Wolpert and Tumer, 2002), which is what the score would lose without it.
 *
 * <p>For the difference a camera has to know, of the targets that it detects, by how many cameras
 * they are detected: its neighbours' reports. Of {@code covered:k} it is the number of its targets
 * that just k cameras detect, of {@code sum:cap} of those that at most cap do. Under {@code
 * lexicographic} and {@code kmin} the score of the whole network hangs on one target that a camera
 * may never see; there each of its targets counts 1/k, the difference of a harmonic sum, so that
 * those which few detect count most.
 */
public final class Utility {
  /** The words of the option {@code utility}. */
  public enum Reading {
    /** The count under kmin, as in the thesis, and the difference under any other objective. */
    OBJECTIVE,
    COUNT,
    DIFFERENCE
  }

  private final Objective objective;
  private final boolean counts;

  public Utility(Reading reading, Objective objective) {
    this.objective = objective;
    this.counts =
        reading == Reading.COUNT || (reading == Reading.OBJECTIVE && objective.rewardsCount());
  }

  /** The option {@code utility}. */
  public static Reading from(Options options) {
    return options.choice(
        "utility",
        Reading.OBJECTIVE,
        "what is rewarded: count, difference (what the score would lose without the camera),"
            + " objective (count under kmin, difference else)");
  }

  /** Whether it is the number of targets detected. */
  public boolean counts() {
    return counts;
  }

  /** A camera's utility at the observation just made; 0 while it is offline. */
  public double of(NetworkView network, int camera) {
    int detected = network.detected(camera);
    return counts || detected == 0 ? detected : difference(network, camera);
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
