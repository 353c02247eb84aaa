package org.hificamsim.agents.search;

/**
 * Improves a choice one camera at a time, until no camera alone can: each takes the set that is
 * worth most beside the others, and of equal ones the one that brings targets nearer to their top.
 */
final class ValueClimb {
  private final CoverageProblem problem;
  private final ValueBounds[] bounds;

  ValueClimb(CoverageProblem problem, ValueBounds[] bounds) {
    this.problem = problem;
    this.bounds = bounds;
  }

  /** Improves the choice by a stage's worth; what it has of those before does not fall. */
  void improve(int stage, Choice choice) {
    boolean better = true;
    while (better) {
      better = false;
      for (int camera = 0; camera < problem.cameras(); camera++) {
        better |=
            problem.endSet(camera) > problem.firstSet(camera) + 1 && turn(camera, stage, choice);
      }
    }
  }

  private boolean turn(int camera, int stage, Choice choice) {
    int before = choice.of(camera);
    int chosen = before;
    choice.take(camera);
    for (int set = problem.firstSet(camera); set < problem.endSet(camera); set++) {
      chosen = set != chosen && better(set, chosen, stage, choice) ? set : chosen;
    }
    choice.give(camera, chosen);
    return chosen != before;
  }

  private boolean better(int set, int than, int stage, Choice choice) {
    for (int i = 0; i < stage; i++) {
      if (gain(set, bounds[i].worth(), choice) < gain(than, bounds[i].worth(), choice)) {
        return false;
      }
    }
    Worth worth = bounds[stage].worth();
    long more = gain(set, worth, choice) - gain(than, worth, choice);
    return more > 0
        || (more == 0 && below(set, worth.top(), choice) > below(than, worth.top(), choice));
  }

  private long gain(int set, Worth worth, Choice choice) {
    long gain = 0;
    for (int word = 0; word < problem.words(); word++) {
      for (long bits = problem.mask(set, word); bits != 0; bits &= bits - 1) {
        int k = choice.coverage((word << 6) + Long.numberOfTrailingZeros(bits));
        gain += worth.of(k + 1) - worth.of(k);
      }
    }
    return gain;
  }

  private int below(int set, int top, Choice choice) {
    int count = 0;
    for (int word = 0; word < problem.words(); word++) {
      for (long bits = problem.mask(set, word); bits != 0; bits &= bits - 1) {
        count += choice.coverage((word << 6) + Long.numberOfTrailingZeros(bits)) < top ? 1 : 0;
      }
    }
    return count;
  }
}
