package org.hificamsim.solver.configuration;

import java.util.Arrays;
import org.hificamsim.solver.BitMatrix;

/**
 * Improves a configuration one camera at a time: each camera takes the set that helps most, given
 * the sets of the others. With every pass, targets that could be covered better get a greater
 * weight, so that the search does not stop where no single camera can improve.
 */
final class LocalSearch {
  /** The greatest weight of a target; all weights begin at 1. */
  static final int MAX_WEIGHT = 1 << 6;

  private final CoverageProblem problem;
  private final RemainingSets remaining;
  private final Stage[] stages;
  private final Configuration trial;
  private final long[] weights;
  private final long[] greatestHelp;

  LocalSearch(CoverageProblem problem, RemainingSets remaining, Stage[] stages) {
    this.problem = problem;
    this.remaining = remaining;
    this.stages = stages;
    trial = new Configuration(problem);
    weights = new long[problem.maxTargets()];
    greatestHelp = new long[stages.length];
  }

  /**
   * Looks for a better configuration by the last of some stages, among the remaining sets, and
   * leaves the best one that it finds in {@code best}.
   *
   * @param stageCount the number of stages, from the first one on
   * @param passes over all cameras at most
   * @return whether the best configuration meets the requirements of these stages
   */
  boolean improve(int stageCount, int passes, Configuration best) {
    Stage last = stages[stageCount - 1];
    trial.copy(best);
    Arrays.fill(weights, 0, problem.targets(), 1);
    boolean reached = areReachedBy(best, stageCount);
    long bestValue = last.value(best.coverage());
    for (int pass = 0; pass < passes && !reached; pass++) {
      improveEachCamera(stageCount);
      long value = last.value(trial.coverage());
      if (value > bestValue && areReachedBy(trial, stageCount - 1)) {
        best.copy(trial);
        bestValue = value;
        reached = areReachedBy(best, stageCount);
      }
      int saturation = last.worth().saturation();
      for (int target = 0; target < problem.targets(); target++) {
        boolean improvable = trial.coverage()[target] < saturation;
        weights[target] += improvable && weights[target] < MAX_WEIGHT ? 1 : 0;
      }
    }
    return reached;
  }

  private boolean areReachedBy(Configuration configuration, int stageCount) {
    boolean reached = true;
    for (int stage = 0; stage < stageCount; stage++) {
      reached &= stages[stage].isReachedBy(configuration.coverage());
    }
    return reached;
  }

  private void improveEachCamera(int stageCount) {
    for (int i = 0; i < remaining.choosingCameras(); i++) {
      int camera = remaining.choosingCamera(i);
      if (remaining.isOpen(camera)) {
        trial.unassign(camera);
        trial.assign(camera, mostHelpfulSet(camera, stageCount));
      }
    }
  }

  private int mostHelpfulSet(int camera, int stageCount) {
    int best = trial.set(camera);
    Arrays.fill(greatestHelp, 0, stageCount, -1);
    helpsMore(best, stageCount);
    for (int set = problem.firstSet(camera); set < problem.endSet(camera); set++) {
      best = remaining.has(set) && helpsMore(set, stageCount) ? set : best;
    }
    return best;
  }

  /**
   * Returns whether a set helps more than all sets so far; if so, it is the one to compare with.
   */
  private boolean helpsMore(int set, int stageCount) {
    boolean more = false;
    for (int stage = 0; stage < stageCount; stage++) {
      long help = help(set, stages[stage].worth());
      if (!more && help < greatestHelp[stage]) {
        return false;
      }
      more |= help > greatestHelp[stage];
      greatestHelp[stage] = help;
    }
    return more;
  }

  /**
   * Returns what a set adds to the sum of weighted worths, plus 1 for each target that it brings
   * nearer to saturation.
   */
  private long help(int set, TargetWorth worth) {
    long help = 0;
    for (int word = 0; word < problem.words(); word++) {
      for (long bits = problem.mask(set, word); bits != 0; bits &= bits - 1) {
        int target = BitMatrix.firstColumn(word, bits);
        int k = trial.coverage()[target];
        help += weights[target] * worth.gain(k) + (k < worth.saturation() ? 1 : 0);
      }
    }
    return help;
  }
}
