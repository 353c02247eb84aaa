package org.hificamsim.network.bandit;

import java.util.Random;

/** The best upper confidence bound, UCB1. */
record Ucb1() implements ArmChoice {
  @Override
  public int choose(Arms arms, Random random) {
    double log = Math.log(arms.total());
    return ArmChoice.best(arm -> arms.mean(arm) + Math.sqrt((2 * log) / arms.count(arm)));
  }
}
