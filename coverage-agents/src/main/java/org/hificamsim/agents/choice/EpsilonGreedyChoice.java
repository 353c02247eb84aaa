package org.hificamsim.agents.choice;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.registry.Options;

/**
 * Takes the best view, but explores with probability epsilon; each camera on its own. Over a
 * camera's decisions n = 0, 1, ... epsilon is {@code max(least, first * decay^n)}, or {@code first}
 * where that is below the least. The defaults keep it constant at the 0.1 of thesis 7.4.3 and
 * 7.4.4.
 */
public final class EpsilonGreedyChoice {
  /** What exploring draws from, uniformly; the thesis leaves it open. */
  private enum Exploration {
    /** Every view but the best one. */
    OTHER,
    /** Every view, the best one included. */
    ANY
  }

  private final double first;
  private final double decay;
  private final double least;
  private final Exploration exploration;
  private SplittableRandom[] randoms = {};
  private double[] epsilon = {};

  /** Reads the options {@code epsilon}, its decay, and {@code explore}. */
  public EpsilonGreedyChoice(Options options) {
    first = options.number("epsilon", 0.1, 0, 1, "probability of exploring, at first");
    decay = options.number("epsilon-decay", 1, 0, 1, "factor on epsilon after each decision");
    least = options.number("epsilon-min", 0, 0, 1, "epsilon does not decay below this");
    exploration =
        options.choice(
            "explore", Exploration.OTHER, "exploring draws a view other than the best, or any");
  }

  /** Gives each camera its generator and its first epsilon. */
  public void begin(NetworkView network, SplittableRandom random) {
    randoms = AbstractDistributedZoomPolicy.split(network, random);
    epsilon = new double[network.cameras()];
    Arrays.fill(epsilon, first);
  }

  /** The camera's next view: {@code best}, or what exploring draws out of {@code views}. */
  public int choose(int camera, int views, int best) {
    double probability = epsilon[camera];
    epsilon[camera] = Math.min(probability, Math.max(least, probability * decay));
    return randoms[camera].nextDouble() < probability ? explore(camera, views, best) : best;
  }

  private int explore(int camera, int views, int best) {
    if (exploration == Exploration.ANY) {
      return randoms[camera].nextInt(views);
    }
    if (views == 1) {
      return best;
    }
    int other = randoms[camera].nextInt(views - 1);
    return other < best ? other : other + 1;
  }
}
