package org.hificamsim.network.auction;

import java.util.Random;
import org.hificamsim.network.agent.Agent;

/** Asks a neighbour with probability (1 + its link) / (1 + the strongest link). */
public final class Smooth extends SelectivePolicy {
  private final Random random;

  public Smooth(Random random, Broadcast fallback) {
    super(fallback);
    this.random = random;
  }

  @Override
  public void startSearch(Agent agent, int target) {
    double strongest = agent.links().strongest(target);
    if (strongest == 0) {
      askAll(agent, target);
    } else {
      askSome(agent, target, random.nextDouble(), strongest);
    }
  }

  @Override
  double chance(double link, double strongest) {
    return (1 + Math.max(link, 0)) / (1 + strongest);
  }
}
