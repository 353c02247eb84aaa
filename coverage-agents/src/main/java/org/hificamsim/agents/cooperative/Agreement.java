package org.hificamsim.agents.cooperative;

import java.util.SplittableRandom;
import org.hificamsim.core.policy.NetworkView;

/** How cameras settle in each step who chooses which view. */
interface Agreement {
  /** The rules by name. */
  enum Rule {
    GREEDY,
    CBBA,
    LOG_LINEAR,
    MAX_SUM,
    NONE;

    Agreement make(Parameters parameters, NetworkView network, SplittableRandom random) {
      int rounds = parameters.rounds();
      return switch (this) {
        case GREEDY -> (at, team) -> greedy(at, team, rounds);
        case CBBA -> new ConsensusAuction(network.cameras());
        case LOG_LINEAR -> new LogLinearLearning(rounds, random);
        case MAX_SUM -> new MaxSum(parameters, network);
        case NONE -> (at, team) -> planForAll(at, team, rounds);
      };
    }
  }

  /** Lets all online cameras choose. */
  void agree(NetworkView network, Team team);

  /**
   * Cameras choose one after the other, each the view that adds most to the choices that it knows
   * of; then again, until nobody changes. Where the worth is submodular, a first choice in turn is
   * at least half as good as the best plan (Fisher, Nemhauser and Wolsey, 1978), and so is a plan
   * that nobody would leave (Vetta, 2002).
   */
  static void greedy(NetworkView network, Team team, int rounds) {
    boolean changed = true;
    for (int round = 0; round < rounds && changed; round++) {
      changed = false;
      for (int camera = 0; camera < network.cameras(); camera++) {
        if (network.online(camera)) {
          changed |= team.choose(network, camera, team.plan(camera).best(network, camera));
        }
      }
    }
  }

  /**
   * Each camera plans for all by itself, in turn as in {@link #greedy}, and does its own part: no
   * message is needed. Over a perfect channel all have the same belief, and so the same plan.
   */
  private static void planForAll(NetworkView network, Team team, int rounds) {
    for (int mind = 0; mind < team.minds(); mind++) {
      boolean changed = true;
      for (int round = 0; round < rounds && changed; round++) {
        changed = false;
        for (int camera = 0; camera < network.cameras(); camera++) {
          changed |= network.online(camera) && team.mind(mind).choose(network, camera);
        }
      }
    }
    for (int camera = 0; camera < network.cameras(); camera++) {
      team.follow(camera);
    }
  }
}
