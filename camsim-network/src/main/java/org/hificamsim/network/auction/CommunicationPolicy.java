package org.hificamsim.network.auction;

import org.hificamsim.network.agent.Agent;

/** Whom a camera asks when it advertises a target (behaviour 8.6). */
public interface CommunicationPolicy {
  /** Advertises the target to the cameras of the policy's choice. */
  void startSearch(Agent agent, int target);

  /** Tells those that were asked that the target is no longer for sale. */
  void stopSearch(Agent agent, int target);
}
