package org.hificamsim.network.bandit;

import java.util.Random;

/** The best upper confidence bound, the chosen arm being kept for longer and longer, UCB2. */
final class Ucb2 implements ArmChoice {
  private final double alpha;
  private final int[] chosen = new int[Arms.COUNT];
  private int interval;

  Ucb2(double alpha) {
    this.alpha = alpha;
  }

  @Override
  public int choose(Arms arms, Random random) {
    int best = ArmChoice.best(arm -> arms.mean(arm) + bonus(arms.count(arm), chosen[arm]));
    interval = (int) (tau(chosen[best] + 1) - tau(chosen[best]));
    chosen[best]++;
    return best;
  }

  @Override
  public int interval(int given) {
    return interval;
  }

  private double bonus(int count, int epochs) {
    double tau = tau(epochs);
    return Math.sqrt(((1 + alpha) * Math.log(Math.E * count / tau)) / (2 * tau));
  }

  private double tau(int epochs) {
    return Math.ceil(Math.pow(1 + alpha, epochs));
  }
}
