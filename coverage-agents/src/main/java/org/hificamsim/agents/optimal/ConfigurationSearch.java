package org.hificamsim.agents.optimal;

import org.hificamsim.agents.search.CoverageSolver;
import org.hificamsim.core.policy.NetworkView;

/** Finds the configuration of candidate levels with the best k_min (Eq 7.1) where targets are. */
final class ConfigurationSearch {
  private final DetectionSets sets;
  private final CoverageSolver solver;

  ConfigurationSearch(NetworkView network, Preference preference) {
    sets = new DetectionSets(network, preference);
    solver = new CoverageSolver(sets.problem(), CoverageSolver.UNLIMITED);
  }

  /** Writes the best configuration into {@code levels}; leaves them when no target is present. */
  void decide(NetworkView network, CandidateLevels candidates, int[] levels) {
    if (!sets.fill(network, candidates)) {
      return;
    }
    solver.solve();
    int online = 0;
    for (int camera = 0; camera < network.cameras(); camera++) {
      if (network.online(camera)) {
        levels[camera] = sets.levelOf(solver.chosen(online++));
      }
    }
  }
}
