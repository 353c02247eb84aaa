package org.hificamsim.network.bandit;

import java.util.List;
import java.util.Random;
import java.util.function.IntToDoubleFunction;
import org.hificamsim.network.agent.Named;

/** The bandits of CamSim: how each chooses an arm (behaviour 9.3). */
public enum BanditAlgorithm implements Named {
  /** Chooses a random arm with probability epsilon, else the arm with the best mean. */
  EPSILON_GREEDY("EpsilonGreedy") {
    @Override
    int choose(Arms arms, double epsilon, Random random) {
      return random.nextDouble() < epsilon ? random.nextInt(Arms.COUNT) : best(arms::mean);
    }
  },
  /** Chooses the arm with the best upper confidence bound. */
  UCB1("UCB1") {
    @Override
    int choose(Arms arms, double epsilon, Random random) {
      double log = Math.log(arms.total());
      return best(arm -> arms.mean(arm) + Math.sqrt((2 * log) / arms.count(arm)));
    }
  },
  /** Chooses the best upper confidence bound, and keeps an arm longer each time it is chosen. */
  UCB2("UCB2") {
    @Override
    int choose(Arms arms, double alpha, Random random) {
      return best(
          arm -> {
            double tau = tau(arms.chosen(arm), alpha);
            double log = Math.log(Math.E * arms.count(arm) / tau);
            return arms.mean(arm) + Math.sqrt(((1 + alpha) * log) / (2 * tau));
          });
    }

    @Override
    int interval(int chosen, BanditParameters parameters) {
      double alpha = parameters.epsilon();
      return (int) (tau(chosen + 1, alpha) - tau(chosen, alpha));
    }

    private static double tau(int chosen, double alpha) {
      return Math.ceil(Math.pow(1 + alpha, chosen));
    }
  },
  /** Chooses the best upper confidence bound, computed from the spread of results. */
  UCB_TUNED("UCBTuned") {
    private static final double MAX_VARIANCE = 1.0 / 4;

    @Override
    int choose(Arms arms, double epsilon, Random random) {
      double log = Math.log(arms.total());
      return best(
          arm -> {
            double bound = arms.deviation(arm) + Math.sqrt((2 * log) / arms.count(arm));
            double variance = Math.min(MAX_VARIANCE, bound);
            return arms.mean(arm) + Math.sqrt(log / arms.count(arm) * variance);
          });
    }
  },
  /** Draws an arm with a probability proportional to the exponential of its mean. */
  SOFT_MAX("SoftMax") {
    @Override
    int choose(Arms arms, double temperature, Random random) {
      double sum = 0.0;
      for (int arm = 0; arm < Arms.COUNT; arm++) {
        sum += weight(arms, arm, temperature);
      }
      double left = random.nextDouble() * sum;
      int next = 0;
      while (left > 0 && next < Arms.COUNT) {
        left -= weight(arms, next++, temperature);
      }
      return next - 1;
    }

    private static double weight(Arms arms, int arm, double temperature) {
      return Math.exp(arms.mean(arm) / temperature);
    }
  },
  /** Draws any arm, from the stream of the run; CamSim's own stream is not seeded. */
  FULL_RANDOM("FullRandom") {
    @Override
    int choose(Arms arms, double epsilon, Random random) {
      return random.nextInt(Arms.COUNT);
    }
  };

  private final String shortName;

  BanditAlgorithm(String shortName) {
    this.shortName = shortName;
  }

  @Override
  public List<String> names() {
    return List.of(shortName, "epics.bandits." + shortName, "epics.learning." + shortName);
  }

  /**
   * Chooses an arm, or {@link BanditSolver#NONE} to keep the current one.
   *
   * @param epsilon the probability of exploring, temperature of SoftMax, or alpha of UCB2
   */
  abstract int choose(Arms arms, double epsilon, Random random);

  /** The number of steps for which an arm is kept if it was chosen {@code chosen} times before. */
  int interval(int chosen, BanditParameters parameters) {
    return parameters.interval();
  }

  /** The first arm with the greatest value; a later arm whose value is NaN never wins. */
  private static int best(IntToDoubleFunction value) {
    int best = 0;
    double greatest = value.applyAsDouble(0);
    for (int arm = 1; arm < Arms.COUNT; arm++) {
      double candidate = value.applyAsDouble(arm);
      if (candidate > greatest) {
        greatest = candidate;
        best = arm;
      }
    }
    return best;
  }
}
