package org.hificamsim.agents.cooperative;

import org.hificamsim.core.policy.NetworkView;

/**
 * An auction of views. Each camera bids what its best view adds; a camera that receives no higher
 * bid takes its view and announces it, and the others bid again, knowing that. This is the
 * consensus-based bundle algorithm (Choi, Brunet and How, 2009) for bundles of one view. The
 * outcome is that of a greedy algorithm which always takes the best view of all cameras next, and
 * until then counts a camera with its last choice.
 */
final class ConsensusAuction implements Agreement {
  /** The bid of a camera that makes none: one that already has its view or is offline. */
  private static final double NO_BID = -1;

  private final double[] bids;

  /** The view that each camera bids for; {@link Plan#NONE} once it has that view. */
  private final int[] views;

  ConsensusAuction(int cameras) {
    bids = new double[cameras];
    views = new int[cameras];
  }

  @Override
  public void agree(NetworkView network, Team team) {
    for (int camera = 0; camera < bids.length; camera++) {
      bids[camera] = network.online(camera) ? 0 : NO_BID;
    }
    while (bid(network, team)) {
      award(network, team);
    }
  }

  /** Lets all cameras without a view bid; returns whether there are any. */
  private boolean bid(NetworkView network, Team team) {
    boolean anyBid = false;
    for (int camera = 0; camera < bids.length; camera++) {
      if (bids[camera] >= 0) {
        Plan plan = team.plan(camera);
        double[] gains = plan.gains(network, camera);
        views[camera] = plan.best(network, camera, gains);
        bids[camera] = gains[views[camera]];
        team.bid(camera, 1);
        anyBid = true;
      }
    }
    return anyBid;
  }

  /**
   * Gives all cameras that received no higher bid their views at the same time: their bids are
   * withdrawn only after all have been compared.
   */
  private void award(NetworkView network, Team team) {
    for (int camera = 0; camera < bids.length; camera++) {
      if (bids[camera] >= 0 && !isOutbid(camera, team)) {
        team.choose(network, camera, views[camera]);
        views[camera] = Plan.NONE;
      }
    }
    for (int camera = 0; camera < bids.length; camera++) {
      bids[camera] = views[camera] == Plan.NONE ? NO_BID : bids[camera];
    }
  }

  private boolean isOutbid(int camera, Team team) {
    boolean outbid = false;
    for (int rival = 0; rival < bids.length && !outbid; rival++) {
      boolean higher =
          bids[rival] > bids[camera] || (bids[rival] == bids[camera] && rival < camera);
      outbid = higher && team.bidHasArrived(rival, camera);
    }
    return outbid;
  }
}
