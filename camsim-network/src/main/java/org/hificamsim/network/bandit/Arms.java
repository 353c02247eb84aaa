package org.hificamsim.network.bandit;

import java.util.Arrays;
import java.util.Random;

/**
 * The knowledge of a bandit about its six arms (behaviour 9.1): how often each was chosen and
 * rewarded, and the sum of its rewards.
 *
 * <p>CamSim keeps a list of results per arm, in which a reward of another arm counts as 0. Only
 * mean and spread of that list are kept here, so that memory does not grow with the steps.
 */
final class Arms {
  /** The number of arms. */
  static final int COUNT = 6;

  private static final double FIRST_REWARD_DIVISOR = 1_000_000;

  private final int[] chosen = new int[COUNT];
  private final int[] counts = new int[COUNT];
  private final double[] rewards = new double[COUNT];
  private final double[] resultMean = new double[COUNT];
  private final double[] squaredSpread = new double[COUNT];
  private int results;

  /** Draws each arm's first, tiny reward. */
  Arms(Random random) {
    Arrays.fill(counts, 1);
    Arrays.setAll(rewards, arm -> random.nextDouble() / FIRST_REWARD_DIVISOR);
  }

  void choose(int arm) {
    chosen[arm]++;
  }

  void reward(int arm, double amount) {
    rewards[arm] += amount;
    counts[arm]++;
    results++;
    for (int other = 0; other < COUNT; other++) {
      double result = other == arm ? amount : 0.0;
      double deviationFromOldMean = result - resultMean[other];
      resultMean[other] += deviationFromOldMean / results;
      squaredSpread[other] += deviationFromOldMean * (result - resultMean[other]);
    }
  }

  /** The number of times the arm was chosen. */
  int chosen(int arm) {
    return chosen[arm];
  }

  /** The number of rewards of the arm, including its first one. */
  int count(int arm) {
    return counts[arm];
  }

  /** The sum of the arm's rewards. */
  double reward(int arm) {
    return rewards[arm];
  }

  double mean(int arm) {
    return rewards[arm] / counts[arm];
  }

  /** The number of rewards of all arms. */
  int total() {
    return COUNT + results;
  }

  /** The root mean square distance of the arm's results from its {@link #mean}. */
  double deviation(int arm) {
    if (results == 0) {
      return 0;
    }
    double shift = mean(arm) - resultMean[arm];
    return Math.sqrt(squaredSpread[arm] / results + shift * shift);
  }
}
