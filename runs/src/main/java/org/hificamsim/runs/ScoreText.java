package org.hificamsim.runs;

import org.hificamsim.core.metrics.Objective;

/** Scores of runs for people: the mean of a step, a share in percent. */
public final class ScoreText {
  private ScoreText() {}

  /**
   * The mean over runs.
   *
   * @param scores of runs of the plan, summed over their steps
   */
  public static String of(RunPlan plan, double[] scores) {
    return of(plan, Estimate.mean(scores).times(1.0 / plan.steps()));
  }

  /** The same of what was made of such scores, of one step. */
  public static String of(RunPlan plan, Estimate score) {
    boolean share = plan.objective().isShare();
    double factor = share ? 100 : 1;
    return score
        .times(factor)
        .within(0, share ? factor : Double.POSITIVE_INFINITY)
        .text(share ? "%.1f %%" : "%.3f");
  }

  /** What such a number says. */
  public static String meaning(Objective objective) {
    return objective.words() + (objective.isShare() ? "" : ", mean of the steps");
  }
}
