package org.hificamsim.network.auction;

import org.hificamsim.network.agent.Advertised;
import org.hificamsim.network.agent.Agent;
import org.hificamsim.network.agent.MessageKind;
import org.hificamsim.network.agent.Neighbours;

/**
 * Asks neighbours by chance, the likelier the stronger the link; where chance picks none, all.
 * Tells those that were asked, and no one else, that a search is over.
 */
abstract class SelectivePolicy implements CommunicationPolicy {
  private final Broadcast fallback;

  SelectivePolicy(Broadcast fallback) {
    this.fallback = fallback;
  }

  /** Asks every neighbour. */
  final void askAll(Agent agent, int target) {
    fallback.startSearch(agent, target);
  }

  /**
   * Asks the neighbours whose chance is above the draw, or all where there are none.
   *
   * @param strongest strength of the agent's strongest link
   */
  final void askSome(Agent agent, int target, double draw, double strongest) {
    Neighbours neighbours = agent.neighbours();
    boolean any = false;
    for (int i = 0; i < neighbours.count(); i++) {
      int neighbour = neighbours.get(i);
      if (chance(agent.linkTo(neighbour, target), strongest) > draw) {
        agent.ask(neighbour, target, true);
        any = true;
      }
    }
    if (!any) {
      askAll(agent, target);
    }
  }

  /**
   * How likely a neighbour is asked.
   *
   * @param link strength of the link to it, negative without one
   */
  abstract double chance(double link, double strongest);

  @Override
  public final void stopSearch(Agent agent, int target) {
    Advertised advertised = agent.advertised();
    if (advertised.isEmpty()) {
      fallback.stopSearch(agent, target);
    } else if (advertised.contains(target)) {
      int camera = advertised.nextAsked(target, 0);
      while (camera >= 0) {
        agent.send(MessageKind.STOP_SEARCH, camera, target, 0);
        camera = advertised.nextAsked(target, camera + 1);
      }
      advertised.close(target);
    }
  }
}
