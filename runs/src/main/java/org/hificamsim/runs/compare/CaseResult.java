package org.hificamsim.runs.compare;

import java.util.Arrays;
import java.util.List;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.ScoredRun;

/**
 * The results of a plan of a comparison.
 *
 * @param runs the run of each repeat, by ascending seed
 * @param meanKMin the k_min of each step, the mean over the repeats
 * @param meanScore the score of each step, the mean over the repeats
 * @param partMeans for each repeat the mean score in each of its {@link FinishedRun#partMeans equal
 *     parts}, from which intervals over time are computed
 */
public record CaseResult(
    RunPlan plan,
    List<ScoredRun> runs,
    double[] meanKMin,
    double[] meanScore,
    double[][] partMeans) {
  /** The metrics that the case has, in the order of files. */
  List<Metric> metrics() {
    ScoredRun first = runs.get(0);
    return Arrays.stream(Metric.values()).filter(metric -> first.has(metric, isOptimum())).toList();
  }

  /** Whether this is the exact optimum that the scores of the others are compared with. */
  public boolean isOptimum() {
    return plan.policy().equals(Yardstick.OPTIMAL.policy());
  }

  /** The mean of a metric over the runs, with its interval cut to what is possible. */
  public Estimate mean(Metric metric) {
    return metric.mean(plan, figures(metric));
  }

  /** The mean score of a step in one of the equal parts, over the runs. */
  public Estimate partMean(int part) {
    double[] means = Arrays.stream(partMeans).mapToDouble(run -> run[part]).toArray();
    return Metric.MEAN_SCORE.mean(plan, means);
  }

  /** The value of a metric for each run; NaN if the run does not have it. */
  public double[] figures(Metric metric) {
    return runs.stream().mapToDouble(run -> run.value(metric)).toArray();
  }
}
