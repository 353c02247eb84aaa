package org.hificamsim.agents.cooperative;

import org.hificamsim.core.policy.NetworkView;

/**
 * Cameras choose one after the other, each the view that adds most to the choices before it; then
 * again, each knowing what all others chose, until nobody changes. The first round is at least half
 * as good as the best plan where the worth is submodular (Fisher, Nemhauser and Wolsey, 1978), and
 * no later one is worse.
 */
final class SequentialGreedy {
  private final int rounds;

  SequentialGreedy(Parameters parameters) {
    rounds = parameters.rounds();
  }

  void agree(NetworkView network, Plan plan) {
    boolean changed = true;
    for (int round = 0; round < rounds && changed; round++) {
      changed = choose(network, plan);
    }
  }

  private static boolean choose(NetworkView network, Plan plan) {
    boolean changed = false;
    for (int camera = 0; camera < network.cameras(); camera++) {
      if (network.online(camera)) {
        int before = plan.view(camera);
        plan.change(camera, Plan.NONE);
        plan.change(camera, plan.best(network, camera));
        changed |= plan.view(camera) != before;
      }
    }
    return changed;
  }
}
