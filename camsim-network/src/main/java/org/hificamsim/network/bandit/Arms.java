package org.hificamsim.network.bandit;

import java.util.Random;

/**
 * What a bandit knows of its six arms (behaviour 9.1): how often each was rewarded, and how much.
 *
 * <p>Of each arm's list of results, where a step that rewarded another arm counts as 0, mean and
 * spread are kept, not the list, so that memory does not grow with the steps.
 */
final class Arms {
  /** How many arms there are. */
  static final int COUNT = 6;

  private static final double FIRST_REWARD_DIVISOR = 1_000_000;

  private final int[] counts = new int[COUNT];
  private final int[] used = new int[COUNT];
  private final double[] rewards = new double[COUNT];
  private final double[] resultMean = new double[COUNT];
  private final double[] squaredSpread = new double[COUNT];
  private int results;

  /** Draws each arm's first, tiny reward. */
  Arms(Random random) {
    for (int arm = 0; arm < COUNT; arm++) {
      counts[arm] = 1;
      rewards[arm] = random.nextDouble() / FIRST_REWARD_DIVISOR;
    }
  }

  void reward(int arm, double amount) {
    rewards[arm] += amount;
    counts[arm]++;
    used[arm]++;
    results++;
    for (int other = 0; other < COUNT; other++) {
      double result = other == arm ? amount : 0.0;
      double before = result - resultMean[other];
      resultMean[other] += before / results;
      squaredSpread[other] += before * (result - resultMean[other]);
    }
  }

  int count(int arm) {
    return counts[arm];
  }

  /** How often the arm was rewarded. */
  int used(int arm) {
    return used[arm];
  }

  /** The sum of the arm's rewards. */
  double reward(int arm) {
    return rewards[arm];
  }

  double mean(int arm) {
    return rewards[arm] / counts[arm];
  }

  /** The counts of all arms together. */
  int total() {
    int total = 0;
    for (int count : counts) {
      total += count;
    }
    return total;
  }

  /** The root mean square distance of the arm's results from its {@link #mean}. */
  double deviation(int arm) {
    if (results == 0) {
      return 0;
    }
    double away = mean(arm) - resultMean[arm];
    return Math.sqrt(squaredSpread[arm] / results + away * away);
  }
}
