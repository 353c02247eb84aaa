package org.hificamsim.agents.optimal;

import java.util.Arrays;
import org.hificamsim.agents.search.Solver;
import org.hificamsim.core.policy.NetworkView;

/**
 * Finds the configuration of candidate views that is best by the network's objective where targets
 * are, and counts where it gave up the proof.
 */
final class ConfigurationSearch {
  /** No set has been chosen. */
  static final int NONE = -1;

  private final ConfigurationSets sets;
  private final Solver solver;
  private final int[] chosen;
  private long unprovenSteps;
  private double gap;

  /**
   * @param nodes search nodes after which a step's proof is given up
   */
  ConfigurationSearch(NetworkView network, ConfigurationSets sets, long nodes) {
    this.sets = sets;
    chosen = new int[network.cameras()];
    Arrays.fill(chosen, NONE);
    solver = Solver.of(network.objective(), sets.problem(), nodes);
  }

  /** Writes the best configuration into {@code views}; leaves them when no target is present. */
  void decide(NetworkView network, int[] views) {
    if (!sets.fill(network)) {
      return;
    }
    solver.solve();
    unprovenSteps += solver.proven() ? 0 : 1;
    gap += solver.gap();
    int online = 0;
    for (int camera = 0; camera < network.cameras(); camera++) {
      if (network.online(camera)) {
        chosen[camera] = solver.chosen(online++);
        views[camera] = sets.viewOf(chosen[camera]);
      }
    }
  }

  /** The set that a camera was given last; {@link #NONE} before the first. */
  int chosen(int camera) {
    return chosen[camera];
  }

  long unprovenSteps() {
    return unprovenSteps;
  }

  double gap() {
    return gap;
  }
}
