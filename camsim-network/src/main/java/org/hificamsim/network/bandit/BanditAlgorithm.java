package org.hificamsim.network.bandit;

import java.util.List;
import java.util.Random;
import java.util.function.IntToDoubleFunction;
import org.hificamsim.network.agent.Named;

/** The bandits of CamSim: how an arm is chosen from what is known (behaviour 9.3). */
public enum BanditAlgorithm implements Named {
  /** Any arm with probability epsilon, else the best mean. */
  EPSILON_GREEDY("EpsilonGreedy") {
    @Override
    int choose(Arms arms, double epsilon, Random random) {
      return random.nextDouble() < epsilon ? random.nextInt(Arms.COUNT) : best(arms::mean);
    }
  },
  /** The best upper confidence bound. */
  UCB1("UCB1") {
    @Override
    int choose(Arms arms, double epsilon, Random random) {
      double log = Math.log(arms.total());
      return best(arm -> arms.mean(arm) + Math.sqrt((2 * log) / arms.count(arm)));
    }
  },
  /** The best upper confidence bound, the chosen arm being kept for longer and longer. */
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
  /** The best upper confidence bound that takes the spread of results into account. */
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
  /** An arm with a probability that grows with the exponential of its mean. */
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
  /** Any arm, from the run's own stream; CamSim draws from one that no seed could repeat. */
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
   * @param epsilon chance of exploring, temperature of SoftMax, or alpha of UCB2
   */
  abstract int choose(Arms arms, double epsilon, Random random);

  /** How many steps an arm that was chosen {@code chosen} times before is kept. */
  int interval(int chosen, BanditParameters parameters) {
    return parameters.interval();
  }

  /** The first arm of the greatest value; a later one that is not a number never wins. */
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
