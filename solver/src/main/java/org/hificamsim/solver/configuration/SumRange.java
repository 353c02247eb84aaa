package org.hificamsim.solver.configuration;

import org.hificamsim.solver.BitMatrix;

/**
 * The range of a sum of worths over all choices of the cameras among their remaining sets: from
 * every target covered by its minimum to every target covered by its maximum.
 *
 * <p>The range is that of the last {@link #update}.
 */
final class SumRange {
  private final CoverageProblem problem;
  private final RemainingSets remaining;
  private final TargetWorth worth;
  private final long[] lastCameraWorth;
  private final BitMatrix indispensable;
  private long min;
  private long max;

  SumRange(CoverageProblem problem, RemainingSets remaining, TargetWorth worth) {
    this.problem = problem;
    this.remaining = remaining;
    this.worth = worth;
    lastCameraWorth = new long[problem.maxTargets()];
    indispensable = new BitMatrix(1, problem.maxTargets());
  }

  /** Computes the range for the sets that remain now. */
  void update() {
    min = 0;
    max = 0;
    for (int target = 0; target < problem.targets(); target++) {
      int minCoverage = remaining.minCoverage(target);
      int maxCoverage = remaining.maxCoverage(target);
      min += worth.value(minCoverage);
      max += worth.value(maxCoverage);
      lastCameraWorth[target] = maxCoverage > minCoverage ? worth.gain(maxCoverage - 1) : 0;
    }
  }

  long min() {
    return min;
  }

  long max() {
    return max;
  }

  /**
   * Removes the sets that lack an indispensable target. A target is indispensable if the sum falls
   * below what is required unless all cameras that can cover the target do so.
   *
   * @param surplus how far the maximum exceeds the sum required
   * @return whether every camera still has a set
   */
  boolean removeSetsWithoutIndispensable(long surplus) {
    boolean anyIndispensable = false;
    indispensable.reshape(problem.targets());
    indispensable.clear(0);
    for (int target = 0; target < problem.targets(); target++) {
      if (lastCameraWorth[target] > surplus) {
        indispensable.set(0, target);
        anyIndispensable = true;
      }
    }
    for (int i = 0; anyIndispensable && i < remaining.choosingCameras(); i++) {
      if (!removeSetsWithoutIndispensable(remaining.choosingCamera(i))) {
        return false;
      }
    }
    return true;
  }

  private boolean removeSetsWithoutIndispensable(int camera) {
    for (int word = 0; word < problem.words(); word++) {
      long needed = remaining.undecided(camera, word) & indispensable.word(0, word);
      for (int set = problem.firstSet(camera); needed != 0 && set < problem.endSet(camera); set++) {
        boolean lacks = (needed & ~problem.mask(set, word)) != 0;
        if (lacks && remaining.has(set) && !remaining.remove(set)) {
          return false;
        }
      }
    }
    return true;
  }

  /**
   * The number of cameras that must cover a target, beyond those that do in any case, for the sum
   * to reach what is required.
   *
   * @param surplus how far the maximum exceeds the sum required
   */
  int camerasNeeded(int target, long surplus) {
    int k = remaining.maxCoverage(target);
    long leastWorth = worth.value(k) - surplus;
    while (k > remaining.minCoverage(target) && worth.value(k - 1) >= leastWorth) {
      k--;
    }
    return k - remaining.minCoverage(target);
  }
}
