package org.hificamsim.network.bandit;

import java.util.Random;

/**
 * Any arm with probability epsilon, else the best mean.
 *
 * @param epsilon chance of exploring
 */
record EpsilonGreedy(double epsilon) implements ArmChoice {
  @Override
  public int choose(Arms arms, Random random) {
    return random.nextDouble() < epsilon ? random.nextInt(Arms.COUNT) : ArmChoice.best(arms::mean);
  }
}
