package org.hificamsim.network.agent;

/**
 * How targets change hands: each camera advertises what it owns, bids for what others sell, and
 * settles its own auctions (behaviour 8.3 to 8.5). An auction opened in a step is settled in it.
 */
public final class Auctions {
  private Auctions() {}

  /**
   * Offers an agent's targets for sale, in the order of the map that holds them (behaviour 8.3).
   */
  public static void advertise(Agent agent) {
    for (int i = 0; i < agent.owned().size(); i++) {
      int target = agent.owned().get(i);
      if (agent.advertises(target)) {
        agent.searches.put(target, agent.camera());
        agent.policy().startSearch(agent, target);
      }
    }
  }

  /** Bids for targets in view that others sell, and claims those nobody owns (behaviour 8.4). */
  public static void bid(Agent agent) {
    InsertionOrder visible = agent.visible();
    int claimed = 0;
    for (int target = visible.first();
        target != InsertionOrder.END;
        target = visible.next(target)) {
      if (agent.searches.contains(target) && !agent.owned.contains(target)) {
        claimed += found(agent, target, claimed) ? 1 : 0;
      }
    }
  }

  /** Answers whoever looks for a target that the agent sees; returns whether it claimed it. */
  private static boolean found(Agent agent, int target, int claimed) {
    int searcher = agent.searches.searcher(target);
    if (searcher == Searches.NOBODY) {
      return agent.mayClaim(claimed) && claim(agent, target);
    }
    if (searcher == agent.camera()) {
      agent.owned.add(target);
      agent.searches.remove(target);
      agent.policy().stopSearch(agent, target);
    } else {
      agent.send(MessageKind.FOUND, searcher, target, agent.value(target));
    }
    return false;
  }

  private static boolean claim(Agent agent, int target) {
    agent.owned.add(target);
    agent.pay(0);
    agent.searches.remove(target);
    CommunicationPolicy.BROADCAST.stopSearch(agent, target);
    return true;
  }

  /** Settles the auctions of an agent (behaviour 8.5). */
  public static void settle(Agent agent) {
    agent.beginSettlement();
    int own = agent.searches.findOwn();
    for (int i = 0; i < own; i++) {
      settle(agent, agent.searches.own(i));
    }
    agent.endSettlement();
  }

  private static void settle(Agent agent, int target) {
    double best = agent.value(target);
    Bids.OfTarget bids = agent.bids.of(target);
    if (bids == null) {
      agent.tally.unsold(agent.sees(target));
      return;
    }
    double beforeBest = best;
    double second = 0;
    int winner = agent.camera();
    for (int i = 0; i < bids.size(); i++) {
      if (!agent.reaches(bids.bidder(i))) {
        continue;
      }
      double value = bids.value(i);
      if (value > best) {
        second = best;
        beforeBest = best;
        best = value;
        winner = bids.bidder(i);
      } else if (value > second) {
        second = value;
      }
    }
    int count = bids.size();
    agent.bids.clear(target);
    sell(agent, target, winner, agent.exactPrices() ? second : beforeBest, count);
  }

  private static void sell(Agent agent, int target, int winner, double price, int bids) {
    agent.earn(price);
    if (winner == agent.camera()) {
      agent.pay(price);
      agent.tally.kept(agent.sees(target), bids);
    } else {
      agent.send(MessageKind.START_TRACKING, winner, target, price);
      agent.links.strengthen(winner, target);
      agent.owned.remove(target);
      agent.advertised.remove(target, winner);
      agent.tally.sold(agent.sees(target));
    }
    agent.policy().stopSearch(agent, target);
    agent.searches.remove(target);
  }
}
