package org.hificamsim.network.auction;

import org.hificamsim.network.agent.Agent;

/** Advertises every owned target in every step (behaviour 8.3). */
public final class ActiveSchedule implements AuctionSchedule {
  @Override
  public boolean advertises(Agent agent, int target) {
    return true;
  }

  @Override
  public double value(Agent agent, int target) {
    return agent.confidence(target);
  }
}
