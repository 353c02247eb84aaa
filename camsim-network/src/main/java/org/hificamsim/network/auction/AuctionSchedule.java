package org.hificamsim.network.auction;

import org.hificamsim.network.agent.Agent;

/**
 * When a camera advertises what it owns, and what a target is worth to it. An instance serves one
 * camera.
 */
public interface AuctionSchedule {
  /** Whether an owned target is advertised in this step; asked once per target and step. */
  boolean advertises(Agent agent, int target);

  /** What the target is worth to the camera: its bid, and what a bid has to exceed. */
  double value(Agent agent, int target);

  /** Called after the camera settled its auctions of the step. */
  default void settled(Agent agent) {}
}
