package org.hificamsim.agents.choice;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.registry.Options;

/**
 * Takes the best view, but explores with probability epsilon, independently for each camera. At a
 * camera's decisions n = 0, 1, ... epsilon is {@code max(minEpsilon, firstEpsilon * decay^n)}, or
 * {@code firstEpsilon} if this is below {@code minEpsilon}. The defaults keep it at the 0.1 of
 * thesis 7.4.3 and 7.4.4.
 */
public final class EpsilonGreedyChoice {
  /** The views from which exploring draws uniformly; the thesis leaves this open. */
  private enum Exploration {
    /** All views except the best one. */
    OTHER,

    /** All views, including the best one. */
    ANY
  }

  private final double firstEpsilon;
  private final double decay;
  private final double minEpsilon;
  private final Exploration explored;
  private SplittableRandom[] randoms = {};
  private double[] epsilon = {};

  /** Reads the options {@code epsilon}, its decay, and {@code explore}. */
  public EpsilonGreedyChoice(Options options) {
    firstEpsilon = options.number("epsilon", 0.1, 0, 1, "probability of exploring, at first");
    decay = options.number("epsilon-decay", 1, 0, 1, "factor on epsilon after each decision");
    minEpsilon = options.number("epsilon-min", 0, 0, 1, "epsilon does not decay below this");
    explored =
        options.choice(
            "explore", Exploration.OTHER, "exploring draws a view other than the best, or any");
  }

  /** Gives each camera its generator and its first epsilon. */
  public void begin(NetworkView network, SplittableRandom random) {
    randoms = AbstractDistributedZoomPolicy.split(network, random);
    epsilon = new double[network.cameras()];
    Arrays.fill(epsilon, firstEpsilon);
  }

  /**
   * Returns the camera's next view.
   *
   * @param views number of views of the camera
   * @param best the view to take unless the camera explores
   */
  public int choose(int camera, int views, int best) {
    double probability = epsilon[camera];
    epsilon[camera] = Math.min(probability, Math.max(minEpsilon, probability * decay));
    return randoms[camera].nextDouble() < probability ? explore(camera, views, best) : best;
  }

  private int explore(int camera, int views, int best) {
    if (explored == Exploration.ANY) {
      return randoms[camera].nextInt(views);
    }
    if (views == 1) {
      return best;
    }
    int drawn = randoms[camera].nextInt(views - 1);
    return drawn < best ? drawn : drawn + 1;
  }
}
