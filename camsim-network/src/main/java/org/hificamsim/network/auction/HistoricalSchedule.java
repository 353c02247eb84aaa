package org.hificamsim.network.auction;

import org.hificamsim.network.agent.Agent;

/**
 * An active or passive schedule whose bids weigh visibility with how long such targets used to stay
 * in view (behaviour 8.7).
 */
public final class HistoricalSchedule implements AuctionSchedule {
  private final AuctionSchedule plain;
  private final Stays stays;

  /** A schedule that advertises when {@code plain} does. */
  public HistoricalSchedule(AuctionSchedule plain, Stays stays) {
    this.plain = plain;
    this.stays = stays;
  }

  @Override
  public boolean advertises(Agent agent, int target) {
    return plain.advertises(agent, target);
  }

  @Override
  public double value(Agent agent, int target) {
    return stays.value(target, agent.confidence(target));
  }

  @Override
  public void settled(Agent agent) {
    stays.endStep();
  }
}
