package org.hificamsim.network.bandit;

import java.util.Arrays;
import java.util.Random;

/**
 * What a bandit knows of its six arms (behaviour 9.1): how often each was chosen and rewarded, and
 * with how much.
 *
 * <p>Of each arm's list of results, where a step that rewarded another arm counts as 0, mean and
 * spread are kept, not the list, so that memory does not grow with the steps.
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
      double before = result - resultMean[other];
      resultMean[other] += before / results;
      squaredSpread[other] += before * (result - resultMean[other]);
    }
  }

  /** How often the arm was chosen. */
  int chosen(int arm) {
    return chosen[arm];
  }

  /** How often the arm was rewarded, its first reward included. */
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

  /** The counts of all arms together. */
  int total() {
    return COUNT + results;
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
