package org.hificamsim.agents.cooperative;

import java.util.SplittableRandom;
import org.hificamsim.core.policy.NetworkView;

/**
 * A protocol by which cameras agree, in each step, which of them chooses which view. Plans begin
 * with the last choice of every camera ({@link Mind#beginPlan}); new choices replace them.
 */
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
        case GREEDY -> (view, team) -> chooseInTurn(view, team, rounds);
        case CBBA -> new ConsensusAuction(network.cameras());
        case LOG_LINEAR -> new LogLinearLearning(rounds, random);
        case MAX_SUM -> new MaxSum(parameters, network);
        case NONE -> (view, team) -> planWithoutMessages(view, team, rounds);
      };
    }
  }

  /** Lets all online cameras choose; called after {@link Team#share}. */
  void agree(NetworkView network, Team team);

  /**
   * Cameras choose one after the other, each the view that adds most to the choices that it knows
   * of; this is repeated until no camera changes its choice. If the worth is submodular, the first
   * choices are at least half as good as the best plan (Fisher, Nemhauser and Wolsey, 1978), and so
   * is a plan that no camera would leave (Vetta, 2002).
   *
   * @param rounds the greatest number of rounds, in which each camera chooses once; the first one
   *     always counts as a change, because no camera has chosen in this step before
   */
  static void chooseInTurn(NetworkView network, Team team, int rounds) {
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
   * Each camera plans for all cameras, in turn as in {@link #chooseInTurn}, and follows its own
   * part of the plan: apart from the reports, no message is needed. Over a perfect channel all have
   * the same belief, and so the same plan.
   */
  private static void planWithoutMessages(NetworkView network, Team team, int rounds) {
    for (Mind mind : team.minds()) {
      boolean changed = true;
      for (int round = 0; round < rounds && changed; round++) {
        changed = false;
        for (int camera = 0; camera < network.cameras(); camera++) {
          changed |= network.online(camera) && mind.replan(network, camera);
        }
      }
    }
    for (int camera = 0; camera < network.cameras(); camera++) {
      team.followPlan(camera);
    }
  }
}
