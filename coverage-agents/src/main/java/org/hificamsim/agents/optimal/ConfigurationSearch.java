package org.hificamsim.agents.optimal;

import org.hificamsim.agents.search.Solver;
import org.hificamsim.core.policy.NetworkView;

/**
 * Finds the configuration of candidate views that is best by the network's objective where targets
 * are, and counts where it gave up the proof.
 */
final class ConfigurationSearch {
  private final DetectionSets sets;
  private final Solver solver;
  private long unprovenSteps;
  private double gap;

  /**
   * @param nodes search nodes after which a step's proof is given up
   */
  ConfigurationSearch(NetworkView network, Preference preference, long nodes) {
    sets = new DetectionSets(network, preference);
    solver = Solver.of(network.objective(), sets.problem(), nodes);
  }

  /** Writes the best configuration into {@code views}; leaves them when no target is present. */
  void decide(NetworkView network, CandidateViews candidates, int[] views) {
    if (!sets.fill(network, candidates)) {
      return;
    }
    solver.solve();
    unprovenSteps += solver.proven() ? 0 : 1;
    gap += solver.gap();
    int online = 0;
    for (int camera = 0; camera < network.cameras(); camera++) {
      if (network.online(camera)) {
        views[camera] = sets.viewOf(solver.chosen(online++));
      }
    }
  }

  long unprovenSteps() {
    return unprovenSteps;
  }

  double gap() {
    return gap;
  }
}
