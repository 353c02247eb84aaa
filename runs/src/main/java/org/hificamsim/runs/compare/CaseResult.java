package org.hificamsim.runs.compare;

import java.util.Arrays;
import java.util.List;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.ScoredRun;

/**
 * One plan with all its runs.
 *
 * @param runs one per repeat, by rising seed
 * @param meanKMin the mean over the repeats of k_min, by step
 * @param meanScore the same of the score
 * @param levels each repeat's mean score in {@link FinishedRun#levels equal parts} of the run: what
 *     intervals over time are made of
 */
public record CaseResult(
    RunPlan plan, List<ScoredRun> runs, double[] meanKMin, double[] meanScore, double[][] levels) {
  /** The metrics that the case has, in the order of files. */
  List<Metric> metrics() {
    ScoredRun first = runs.get(0);
    return Arrays.stream(Metric.values()).filter(metric -> first.has(metric, isOptimum())).toList();
  }

  /** Whether this is the exact optimum that the others are measured by. */
  public boolean isOptimum() {
    return plan.policy().equals(Yardstick.OPTIMAL.policy());
  }

  /** A metric's value of every run, NaN where there is none. */
  public double[] figures(Metric metric) {
    return runs.stream().mapToDouble(run -> run.value(metric)).toArray();
  }
}
