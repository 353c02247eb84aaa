package org.hificamsim.solver.way;

import org.hificamsim.core.metrics.Objective;

/**
 * The worth of a further camera's set in a step: the change of the score, and a share of the
 * progress towards the next change, so that cameras join where only several of them gain anything.
 */
final class StepGuide {
  private static final double FALL = 0.25;
  private static final int MAX_COUNTED = 16;

  private final WayProblem problem;
  private final boolean byLeast;
  private final boolean isShare;
  private final StepWorth score;
  private final StepWorth progress;
  private final int[] added;

  StepGuide(WayProblem problem) {
    this.problem = problem;
    Objective objective = problem.objective();
    byLeast = objective.isLeast();
    isShare = objective.isShare();
    score = byLeast ? null : worth(objective, problem.cameras());
    progress = byLeast ? decreasing() : progress(score);
    added = new int[problem.momentCount()];
  }

  /** The worth of a target in the sum of a step's score, before the division for a share. */
  static StepWorth worth(Objective objective, int cameras) {
    long[] table = objective.worths(cameras, 1).get(0);
    int last = table.length - 1;
    while (last > 0 && table[last] == table[last - 1]) {
      last--;
    }
    double[] values = new double[last + 1];
    for (int k = 0; k <= last; k++) {
      values[k] = table[k];
    }
    return new StepWorth(values);
  }

  private static StepWorth decreasing() {
    double[] values = new double[MAX_COUNTED];
    double gain = 1;
    for (int k = 1; k < MAX_COUNTED; k++) {
      values[k] = values[k - 1] + gain;
      gain *= FALL;
    }
    return new StepWorth(values);
  }

  private static StepWorth progress(StepWorth score) {
    double[] values = new double[score.values().length];
    for (int k = 1; k < values.length; k++) {
      values[k] = score.value(values.length) * k / (values.length - 1);
    }
    return new StepWorth(values);
  }

  /** The gain of a set in a step with this coverage; a share weighs progress towards a gain. */
  double gain(int step, int set, int[] coverage, double share) {
    int count = problem.end(step) - problem.start(step);
    double scoreGain = byLeast ? leastGain(step, set, coverage) : sum(score, set, coverage);
    double scale = isShare || byLeast ? count : 1;
    double progressGain = share == 0 ? 0 : share * sum(progress, set, coverage) / scale;
    return (byLeast ? scoreGain : scoreGain / scale) + progressGain;
  }

  private double sum(StepWorth worth, int set, int[] coverage) {
    double sum = 0;
    for (int moment : problem.moments(set)) {
      sum += worth.gain(coverage[moment]);
    }
    return sum;
  }

  private double leastGain(int step, int set, int[] coverage) {
    for (int moment : problem.moments(set)) {
      added[moment] = 1;
    }
    int before = Integer.MAX_VALUE;
    int after = Integer.MAX_VALUE;
    for (int moment = problem.start(step); moment < problem.end(step); moment++) {
      before = Math.min(before, coverage[moment]);
      after = Math.min(after, coverage[moment] + added[moment]);
    }
    for (int moment : problem.moments(set)) {
      added[moment] = 0;
    }
    return after - before;
  }
}
