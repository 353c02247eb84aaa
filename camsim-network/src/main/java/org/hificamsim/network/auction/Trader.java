package org.hificamsim.network.auction;

import org.hificamsim.network.agent.Agent;
import org.hificamsim.network.agent.Bids;
import org.hificamsim.network.agent.InsertionOrder;
import org.hificamsim.network.agent.MessageKind;
import org.hificamsim.network.agent.Searches;

/**
 * One camera at the market: it advertises, bids and settles its auctions, under a schedule and a
 * communication policy (behaviour 8.3 to 8.5). An auction opened in a step is settled in the same.
 */
public final class Trader {
  private final Agent agent;
  private final boolean exactPrices;
  private AuctionSchedule schedule;
  private CommunicationPolicy policy;

  /**
   * @param exactPrices whether the price is the second highest value; CamSim's is the best before
   *     the last improvement (quirk Q14)
   */
  public Trader(
      Agent agent, AuctionSchedule schedule, CommunicationPolicy policy, boolean exactPrices) {
    this.agent = agent;
    this.schedule = schedule;
    this.policy = policy;
    this.exactPrices = exactPrices;
  }

  public Agent agent() {
    return agent;
  }

  public AuctionSchedule schedule() {
    return schedule;
  }

  /** Takes over another schedule and policy; all state is kept. */
  public void follow(AuctionSchedule newSchedule, CommunicationPolicy newPolicy) {
    schedule = newSchedule;
    policy = newPolicy;
  }

  /** Offers owned targets for sale, in the order of the map that holds them (behaviour 8.3). */
  public void advertise() {
    for (int i = 0; i < agent.owned().size(); i++) {
      int target = agent.owned().get(i);
      if (schedule.advertises(agent, target)) {
        agent.searches().put(target, agent.camera());
        policy.startSearch(agent, target);
      }
    }
  }

  /**
   * Bids for the targets in view that others sell, and claims those that nobody owns (behaviour
   * 8.4).
   */
  public void bid(InsertionOrder visible) {
    Searches searches = agent.searches();
    int claimed = 0;
    for (int target = visible.first();
        target != InsertionOrder.END;
        target = visible.next(target)) {
      if (!searches.contains(target) || agent.owned().contains(target)) {
        continue;
      }
      int searcher = searches.searcher(target);
      if (searcher == Searches.NOBODY) {
        if (agent.mayClaim(claimed)) {
          claimed++;
          claim(target);
        }
      } else if (searcher == agent.camera()) {
        agent.owned().add(target);
        searches.remove(target);
        policy.stopSearch(agent, target);
      } else {
        double value = schedule.value(agent, target);
        agent.send(MessageKind.FOUND, searcher, target, value);
      }
    }
  }

  private void claim(int target) {
    agent.owned().add(target);
    agent.pay(0);
    agent.searches().remove(target);
    Broadcast.COUNTED.stopSearch(agent, target);
  }

  /** Settles this camera's auctions (behaviour 8.5). */
  public void settle() {
    agent.resetCounters();
    agent.links().decay();
    Searches searches = agent.searches();
    int target = searches.first();
    while (target != InsertionOrder.END) {
      int next = searches.next(target);
      if (searches.searcher(target) == agent.camera()) {
        settle(target);
      }
      target = next;
    }
    schedule.settled(agent);
  }

  private void settle(int target) {
    double best = schedule.value(agent, target);
    Bids bids = agent.bids().of(target);
    if (bids == null) {
      agent.tally().unsold(agent.sees(target));
      return;
    }
    double price = best;
    double second = 0;
    int winner = agent.camera();
    for (int i = 0; i < bids.size(); i++) {
      if (!agent.reaches(bids.bidder(i))) {
        continue;
      }
      double value = bids.value(i);
      if (value > best) {
        second = best;
        price = best;
        best = value;
        winner = bids.bidder(i);
      } else if (value > second) {
        second = value;
      }
    }
    int count = bids.size();
    agent.bids().clear(target);
    finish(target, winner, exactPrices ? second : price, count);
  }

  private void finish(int target, int winner, double price, int bids) {
    agent.earn(price);
    if (winner == agent.camera()) {
      agent.pay(price);
      agent.tally().kept(agent.sees(target), bids);
    } else {
      agent.send(MessageKind.START_TRACKING, winner, target, price);
      agent.links().strengthen(winner, target);
      agent.owned().remove(target);
      agent.advertised().remove(target, winner);
      agent.tally().sold(agent.sees(target));
    }
    policy.stopSearch(agent, target);
    agent.searches().remove(target);
  }
}
