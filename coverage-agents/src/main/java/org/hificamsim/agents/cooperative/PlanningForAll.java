package org.hificamsim.agents.cooperative;

import org.hificamsim.core.policy.NetworkView;

/**
 * Each camera plans for all by itself, in turn as in {@link SequentialGreedy}, and does its own
 * part: no message is needed. Over a perfect channel all have the same belief, and so the same
 * plan.
 */
final class PlanningForAll implements Agreement {
  private final int rounds;

  PlanningForAll(int rounds) {
    this.rounds = rounds;
  }

  @Override
  public void agree(NetworkView network, Team team) {
    for (int mind = 0; mind < team.minds(); mind++) {
      plan(network, team.mind(mind));
    }
    for (int camera = 0; camera < network.cameras(); camera++) {
      team.follow(camera);
    }
  }

  private void plan(NetworkView network, Mind mind) {
    boolean changed = true;
    for (int round = 0; round < rounds && changed; round++) {
      changed = false;
      for (int camera = 0; camera < network.cameras(); camera++) {
        changed |= network.online(camera) && choose(network, mind, camera);
      }
    }
  }

  private static boolean choose(NetworkView network, Mind mind, int camera) {
    int before = mind.plan().view(camera);
    int view = mind.plan().best(network, camera);
    mind.hear(camera, view, network.step(), network.step());
    return view != before;
  }
}
