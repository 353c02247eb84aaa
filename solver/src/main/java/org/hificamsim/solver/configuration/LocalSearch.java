package org.hificamsim.solver.configuration;

import java.util.Arrays;
import org.hificamsim.solver.BitMatrix;
import org.hificamsim.solver.Exchange;

/**
 * Improves a configuration one camera at a time: each camera takes the set that helps most, given
 * the sets of the others. With every pass, targets that could be covered better get a greater
 * weight, so that the search does not stop where no single camera can improve.
 */
final class LocalSearch implements Exchange.Choice {
  /** The greatest weight of a target; all weights begin at 1. */
  static final int MAX_WEIGHT = 1 << 6;

  private final CoverageProblem problem;
  private final BitMatrix masks;
  private final RemainingSets remaining;
  private final Stage[] stages;
  private final Configuration trial;
  private final long[] weights;
  private final long[] greatestHelp;
  private int stageCount;
  private Configuration best;
  private long bestValue;
  private boolean reached;

  LocalSearch(CoverageProblem problem, RemainingSets remaining, Stage[] stages) {
    this.problem = problem;
    masks = problem.masks();
    this.remaining = remaining;
    this.stages = stages;
    trial = new Configuration(problem);
    weights = new long[problem.maxTargets()];
    greatestHelp = new long[stages.length];
  }

  /**
   * Looks for a better configuration by the last of some stages, among the remaining sets, and
   * leaves the best one that it finds in {@code newBest}.
   *
   * @param newStageCount the number of stages, from the first one on
   * @param passes over all cameras at most
   * @return whether the best configuration meets the requirements of these stages
   */
  boolean improve(int newStageCount, int passes, Configuration newBest) {
    stageCount = newStageCount;
    best = newBest;
    bestValue = last().value(best.coverage());
    reached = areReachedBy(best, stageCount);
    trial.copy(best);
    Arrays.fill(weights, 0, problem.targets(), 1);
    Exchange.improve(this, reached ? 0 : passes);
    return reached;
  }

  private Stage last() {
    return stages[stageCount - 1];
  }

  private boolean areReachedBy(Configuration configuration, int count) {
    boolean areReached = true;
    for (int stage = 0; stage < count; stage++) {
      areReached &= stages[stage].isReachedBy(configuration.coverage());
    }
    return areReached;
  }

  @Override
  public int choosers() {
    return remaining.choosingCameras();
  }

  @Override
  public boolean exchange(int chooser) {
    int camera = remaining.choosingCamera(chooser);
    if (remaining.isOpen(camera)) {
      trial.unassign(camera);
      trial.assign(camera, mostHelpfulSet(camera));
    }
    return true;
  }

  /** Keeps a better configuration, and makes what could be covered better count more. */
  @Override
  public boolean endPass(boolean changed) {
    long value = last().value(trial.coverage());
    if (value > bestValue && areReachedBy(trial, stageCount - 1)) {
      best.copy(trial);
      bestValue = value;
      reached = areReachedBy(best, stageCount);
    }
    int saturation = last().worth().saturation();
    for (int target = 0; target < problem.targets(); target++) {
      boolean improvable = trial.coverage()[target] < saturation;
      weights[target] += improvable && weights[target] < MAX_WEIGHT ? 1 : 0;
    }
    return !reached;
  }

  private int mostHelpfulSet(int camera) {
    int most = trial.set(camera);
    Arrays.fill(greatestHelp, 0, stageCount, -1);
    helpsMore(most);
    for (int set = problem.firstSet(camera); set < problem.endSet(camera); set++) {
      most = remaining.has(set) && helpsMore(set) ? set : most;
    }
    return most;
  }

  /**
   * Returns whether a set helps more than all sets so far; if so, it is the one to compare with.
   */
  private boolean helpsMore(int set) {
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
    for (int word = 0; word < masks.words(); word++) {
      for (long bits = masks.word(set, word); bits != 0; bits &= bits - 1) {
        int target = BitMatrix.firstColumn(word, bits);
        int k = trial.coverage()[target];
        help += weights[target] * worth.gain(k) + (k < worth.saturation() ? 1 : 0);
      }
    }
    return help;
  }
}
