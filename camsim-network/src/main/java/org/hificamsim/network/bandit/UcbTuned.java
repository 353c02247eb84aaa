package org.hificamsim.network.bandit;

import java.util.Random;

/** The best upper confidence bound that takes the spread of results into account, UCB-Tuned. */
record UcbTuned() implements ArmChoice {
  private static final double MOST_VARIANCE = 1.0 / 4;

  @Override
  public int choose(Arms arms, Random random) {
    double log = Math.log(arms.total());
    return ArmChoice.best(
        arm -> {
          double bound = arms.deviation(arm) + Math.sqrt((2 * log) / arms.count(arm));
          return arms.mean(arm) + Math.sqrt(log / arms.count(arm) * Math.min(MOST_VARIANCE, bound));
        });
  }
}
