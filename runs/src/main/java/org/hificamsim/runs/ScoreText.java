package org.hificamsim.runs;

import org.hificamsim.core.metrics.Objective;

/** Writes the mean score of a step for people; shares are in percent. */
public final class ScoreText {
  private ScoreText() {}

  /**
   * The mean of a step's score over the runs of a plan.
   *
   * @param scores the scores of the runs, each summed over its steps
   */
  public static String of(RunPlan plan, double[] scores) {
    return of(plan, Metric.SCORE.mean(plan, scores).times(1.0 / plan.steps()));
  }

  /** The estimate of a step's score. */
  public static String of(RunPlan plan, Estimate score) {
    boolean isShare = plan.objective().isShare();
    double factor = isShare ? 100 : 1;
    return score.times(factor).text(isShare ? "%.1f %%" : "%.3f");
  }

  /** The meaning of a score that this class writes. */
  public static String meaning(Objective objective) {
    return objective.words() + (objective.isShare() ? "" : ", mean of the steps");
  }
}
