package org.hificamsim.network.auction;

import java.util.Random;
import org.hificamsim.network.agent.Agent;

/** Asks a neighbour with the strength of its link as probability, without a link with 0.1. */
public final class Step extends SelectivePolicy {
  private static final double WITHOUT_LINK = 0.1;

  private final Random random;

  public Step(Random random, Broadcast fallback) {
    super(fallback);
    this.random = random;
  }

  @Override
  public void startSearch(Agent agent, int target) {
    askSome(agent, target, random.nextDouble(), 0);
  }

  @Override
  double chance(double link, double strongest) {
    return link >= 0 ? link : WITHOUT_LINK;
  }
}
