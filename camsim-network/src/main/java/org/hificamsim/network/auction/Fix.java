package org.hificamsim.network.auction;

import org.hificamsim.network.agent.Agent;
import org.hificamsim.network.agent.Links;
import org.hificamsim.network.agent.MessageKind;

/** Asks every camera linked to, and counts nothing as sent. */
public final class Fix implements CommunicationPolicy {
  private final int cameras;

  /**
   * @param cameras how many there are; names of higher numbers are no cameras and are asked in vain
   */
  public Fix(int cameras) {
    this.cameras = cameras;
  }

  @Override
  public void startSearch(Agent agent, int target) {
    agent.advertised().close(target);
    agent.advertised().open(target);
    Links links = agent.links();
    for (int i = 0; i < links.count(); i++) {
      if (links.name(i) < cameras) {
        agent.advertised().add(target, links.name(i));
        agent.send(MessageKind.START_SEARCH, links.name(i), target, 0);
      }
    }
  }

  @Override
  public void stopSearch(Agent agent, int target) {
    Links links = agent.links();
    for (int i = 0; i < links.count(); i++) {
      if (links.name(i) < cameras) {
        agent.send(MessageKind.STOP_SEARCH, links.name(i), target, 0);
      }
    }
    agent.advertised().close(target);
  }
}
