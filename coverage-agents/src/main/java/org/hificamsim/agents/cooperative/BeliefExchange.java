package org.hificamsim.agents.cooperative;

import java.util.Arrays;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.SeenPairs;

/** Lets cameras report to each other what they see, and keeps their beliefs up to date. */
final class BeliefExchange {
  private final SeenPairs pairs = new SeenPairs();
  private final SightingReport[] reports;
  private final Team team;

  /**
   * @param map the obstacles that the cameras know
   * @param individual whether each camera has its own mind even over a perfect channel
   */
  BeliefExchange(Parameters parameters, NetworkView network, Obstacles map, boolean individual) {
    reports = new SightingReport[network.cameras()];
    Arrays.setAll(reports, camera -> new SightingReport(parameters.identified()));
    Site site = new Site(network, map, parameters.cells());
    team = new Team(parameters, site, network, individual || !network.channel().isPerfect());
  }

  /** Lets all cameras report what they see; to be called once in each step, before decisions. */
  void share(NetworkView network) {
    look(network);
    team.share(network, reports);
  }

  /** Reports where targets are now, as seen through the views of the step before. */
  private void look(NetworkView network) {
    for (int camera = 0; camera < reports.length; camera++) {
      reports[camera].begin(network, camera);
    }
    network.findSeen(pairs);
    for (int pair = 0; pair < pairs.count(); pair++) {
      reports[pairs.camera(pair)].add(network, pairs, pair);
    }
  }

  Team team() {
    return team;
  }
}
