package org.hificamsim.agents.cooperative;

import org.hificamsim.core.policy.NetworkView;

/**
 * Cameras choose one after the other, each the view that adds most to the choices that it knows of;
 * then again, until nobody changes. Where the worth is submodular, a first choice in turn is at
 * least half as good as the best plan (Fisher, Nemhauser and Wolsey, 1978), and so is a plan that
 * nobody would leave (Vetta, 2002).
 */
final class SequentialGreedy implements Agreement {
  private final int rounds;

  SequentialGreedy(int rounds) {
    this.rounds = rounds;
  }

  @Override
  public void agree(NetworkView network, Team team) {
    boolean changed = true;
    for (int round = 0; round < rounds && changed; round++) {
      changed = chooseInTurn(network, team);
    }
  }

  private static boolean chooseInTurn(NetworkView network, Team team) {
    boolean changed = false;
    for (int camera = 0; camera < network.cameras(); camera++) {
      if (network.online(camera)) {
        changed |= team.choose(network, camera, team.plan(camera).best(network, camera));
      }
    }
    return changed;
  }
}
