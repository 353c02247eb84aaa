package org.hificamsim.network.auction;

import org.hificamsim.network.agent.Agent;
import org.hificamsim.network.agent.MessageKind;
import org.hificamsim.network.agent.Neighbours;

/** Asks every neighbour, as the first choice or as what other policies fall back to. */
public final class Broadcast implements CommunicationPolicy {
  /** Counts what it sends. */
  public static final Broadcast COUNTED = new Broadcast(true);

  /** Does not count: the fall-back of cameras that switch schedules (behaviour 9.4). */
  public static final Broadcast UNCOUNTED = new Broadcast(false);

  private final boolean counted;

  private Broadcast(boolean counted) {
    this.counted = counted;
  }

  @Override
  public void startSearch(Agent agent, int target) {
    Neighbours neighbours = agent.neighbours();
    for (int i = 0; i < neighbours.count(); i++) {
      agent.ask(neighbours.get(i), target, counted);
    }
  }

  @Override
  public void stopSearch(Agent agent, int target) {
    Neighbours neighbours = agent.neighbours();
    for (int i = 0; i < neighbours.count(); i++) {
      agent.send(MessageKind.STOP_SEARCH, neighbours.get(i), target, 0);
    }
    agent.advertised().close(target);
  }
}
