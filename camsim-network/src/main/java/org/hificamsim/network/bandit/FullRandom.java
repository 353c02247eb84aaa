package org.hificamsim.network.bandit;

import java.util.Random;

/** Any arm, from the run's own stream; CamSim's drew from one that no seed could repeat. */
record FullRandom() implements ArmChoice {
  @Override
  public int choose(Arms arms, Random random) {
    return random.nextInt(Arms.COUNT);
  }
}
