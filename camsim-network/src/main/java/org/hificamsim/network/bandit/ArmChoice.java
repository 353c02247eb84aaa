package org.hificamsim.network.bandit;

import java.util.Random;

/** How a bandit chooses an arm from what it knows (behaviour 9.3). */
interface ArmChoice {
  /** Chooses an arm, or {@link BanditSolver#NONE} to keep the current one. */
  int choose(Arms arms, Random random);

  /** How many steps the arm just chosen is kept, if that is not the parameter's to say. */
  default int interval(int given) {
    return given;
  }

  /** The value of an arm, to be compared. */
  interface Value {
    double of(int arm);
  }

  /** The first arm of the greatest value; a later one that is not a number never wins. */
  static int best(Value value) {
    int best = 0;
    double most = value.of(0);
    for (int arm = 1; arm < Arms.COUNT; arm++) {
      double candidate = value.of(arm);
      if (candidate > most) {
        most = candidate;
        best = arm;
      }
    }
    return best;
  }
}
