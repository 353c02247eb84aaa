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
      return switch (this) {
        case GREEDY -> new SequentialGreedy(parameters.rounds());
        case CBBA -> new ConsensusAuction(network.cameras());
        case LOG_LINEAR -> new LogLinearLearning(parameters.rounds(), random);
        case MAX_SUM -> new MaxSum(parameters, network);
        case NONE -> new PlanningForAll(parameters.rounds());
      };
    }
  }

  /** Lets all online cameras choose. */
  void agree(NetworkView network, Team team);
}
