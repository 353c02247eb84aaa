package org.hificamsim.agents.search;

import java.util.Arrays;

/**
 * Improves a configuration one camera at a time: each takes the set that gains most with the others
 * as they are. Targets that could be covered better weigh more from pass to pass, so that the
 * search does not rest where no single camera can improve.
 */
final class LocalSearch {
  /** So much more than at first a target weighs at most. */
  static final int MAX_NEED = 1 << 6;

  private final CoverageProblem problem;
  private final RemainingSets remaining;
  private final Stage[] stages;
  private final Configuration trial;
  private final long[] need;
  private final long[] most; // help of the best set, by stage

  LocalSearch(CoverageProblem problem, RemainingSets remaining, Stage[] stages) {
    this.problem = problem;
    this.remaining = remaining;
    this.stages = stages;
    trial = new Configuration(problem);
    need = new long[problem.maxTargets()];
    most = new long[stages.length];
  }

  /**
   * Looks for a better configuration by the last of some stages, among the remaining sets, and
   * leaves the best that it met in {@code best}.
   *
   * @return whether all stages have what is required of them within that many passes
   */
  boolean reach(int count, int passes, Configuration best) {
    trial.copy(best);
    Arrays.fill(need, 0, problem.targets(), 1);
    boolean reached = reaches(count, best);
    long bestValue = stages[count - 1].value(best.coverage());
    for (int pass = 0; pass < passes && !reached; pass++) {
      improve(count);
      long value = stages[count - 1].value(trial.coverage());
      if (value > bestValue && reaches(count - 1, trial)) {
        best.copy(trial);
        bestValue = value;
        reached = reaches(count, best);
      }
      int top = stages[count - 1].worth().top();
      for (int target = 0; target < problem.targets(); target++) {
        need[target] += trial.coverage()[target] < top && need[target] < MAX_NEED ? 1 : 0;
      }
    }
    return reached;
  }

  private boolean reaches(int count, Configuration configuration) {
    boolean reached = true;
    for (int stage = 0; stage < count; stage++) {
      reached &= stages[stage].isReached(configuration.coverage());
    }
    return reached;
  }

  private void improve(int count) {
    for (int i = 0; i < remaining.withChoice(); i++) {
      int camera = remaining.withChoice(i);
      if (remaining.isOpen(camera)) {
        trial.take(camera);
        trial.give(camera, best(camera, count));
      }
    }
  }

  private int best(int camera, int count) {
    int best = trial.of(camera);
    Arrays.fill(most, 0, count, -1);
    helpsMore(best, count);
    for (int set = problem.firstSet(camera); set < problem.endSet(camera); set++) {
      best = remaining.has(set) && helpsMore(set, count) ? set : best;
    }
    return best;
  }

  /** Whether a set helps more than the best so far, which it then is. */
  private boolean helpsMore(int set, int count) {
    boolean more = false;
    for (int stage = 0; stage < count; stage++) {
      long help = help(set, stages[stage].worth());
      if (!more && help < most[stage]) {
        return false;
      }
      more |= help > most[stage];
      most[stage] = help;
    }
    return more;
  }

  /** What a set adds; of sets that add as much, the one that brings more targets nearer to it. */
  private long help(int set, TargetWorth worth) {
    long help = 0;
    for (int word = 0; word < problem.words(); word++) {
      for (long bits = problem.mask(set, word); bits != 0; bits &= bits - 1) {
        int target = (word << 6) + Long.numberOfTrailingZeros(bits);
        int k = trial.coverage()[target];
        help += need[target] * worth.gain(k) + (k < worth.top() ? 1 : 0);
      }
    }
    return help;
  }
}
