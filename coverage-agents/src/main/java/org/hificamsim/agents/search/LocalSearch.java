package org.hificamsim.agents.search;

import java.util.Arrays;

/**
 * Improves a choice one camera at a time towards a coverage k: each takes the set that helps the
 * targets below k most, and targets that stay below weigh more from pass to pass, so that the
 * search does not rest where no single camera can improve.
 */
final class LocalSearch {
  private final CoverageProblem problem;
  private final Remaining remaining;
  private final Choice choice;
  private final long[] need;

  LocalSearch(CoverageProblem problem, Remaining remaining) {
    this.problem = problem;
    this.remaining = remaining;
    choice = new Choice(problem);
    need = new long[problem.maxTargets()];
  }

  /**
   * Looks for a better choice among the remaining sets, starting from {@code best}, and leaves the
   * best that it met there.
   *
   * @return whether every target is covered k times within that many passes
   */
  boolean reach(int k, int passes, Choice best) {
    choice.copy(best);
    Arrays.fill(need, 0, problem.targets(), 1);
    int most = best.least();
    for (int pass = 0; pass < passes && most < k; pass++) {
      improve(k);
      int least = choice.least();
      if (least > most) {
        best.copy(choice);
        most = least;
      }
      for (int target = 0; target < problem.targets(); target++) {
        need[target] += choice.coverage(target) < k ? 1 : 0;
      }
    }
    return most >= k;
  }

  private void improve(int k) {
    for (int i = 0; i < remaining.openCameras(); i++) {
      int camera = remaining.openCamera(i);
      if (remaining.count(camera) > 1) {
        choice.take(camera);
        choice.give(camera, mostHelpful(camera, k));
      }
    }
  }

  private int mostHelpful(int camera, int k) {
    int chosen = choice.of(camera);
    long most = help(chosen, k);
    for (int set = problem.firstSet(camera); set < problem.endSet(camera); set++) {
      if (remaining.has(set) && set != chosen) {
        long help = help(set, k);
        if (help > most) {
          most = help;
          chosen = set;
        }
      }
    }
    return chosen;
  }

  private long help(int set, int k) {
    long help = 0;
    for (int word = 0; word < problem.words(); word++) {
      for (long bits = problem.mask(set, word); bits != 0; bits &= bits - 1) {
        int target = (word << 6) + Long.numberOfTrailingZeros(bits);
        help += choice.coverage(target) < k ? need[target] : 0;
      }
    }
    return help;
  }
}
