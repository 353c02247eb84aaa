package org.hificamsim.agents.cooperative;

import org.hificamsim.core.policy.NetworkView;

/**
 * Cameras bid with what their best view adds; one that receives no higher bid takes its view and
 * says so, and the others bid again, knowing that. It is the consensus-based bundle algorithm
 * (Choi, Brunet and How, 2009) for bundles of one view: the outcome is the greedy one that takes
 * the best view of all cameras first.
 */
final class ConsensusAuction implements Agreement {
  private final double[] bids; // of each camera; below 0 where it has its view
  private final int[] views;

  ConsensusAuction(int cameras) {
    bids = new double[cameras];
    views = new int[cameras];
  }

  @Override
  public void agree(NetworkView network, Team team) {
    for (int camera = 0; camera < bids.length; camera++) {
      bids[camera] = network.online(camera) ? 0 : -1;
    }
    while (bid(network, team)) {
      award(network, team);
    }
  }

  private boolean bid(NetworkView network, Team team) {
    boolean any = false;
    for (int camera = 0; camera < bids.length; camera++) {
      if (bids[camera] >= 0) {
        Plan plan = team.plan(camera);
        int before = plan.view(camera);
        views[camera] = plan.best(network, camera);
        bids[camera] = plan.gain(views[camera]);
        if (before != Plan.NONE) {
          plan.choose(camera, before); // until it wins
        }
        team.bid(network, camera, 1);
        any = true;
      }
    }
    return any;
  }

  /** All that receive no higher bid win at the same time. */
  private void award(NetworkView network, Team team) {
    for (int camera = 0; camera < bids.length; camera++) {
      if (bids[camera] >= 0 && !isOutbid(camera, team)) {
        team.choose(network, camera, views[camera]);
        views[camera] = -1;
      }
    }
    for (int camera = 0; camera < bids.length; camera++) {
      bids[camera] = views[camera] < 0 ? -1 : bids[camera];
    }
  }

  private boolean isOutbid(int camera, Team team) {
    boolean outbid = false;
    for (int other = 0; other < bids.length && !outbid; other++) {
      boolean higher =
          bids[other] > bids[camera] || (bids[other] == bids[camera] && other < camera);
      outbid = higher && team.hears(camera, other);
    }
    return outbid;
  }
}
