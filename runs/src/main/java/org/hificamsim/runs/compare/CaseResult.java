package org.hificamsim.runs.compare;

import java.util.ArrayList;
import java.util.List;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.Proof;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.RunResult;

/**
 * One plan with all its runs.
 *
 * @param runs one per repeat, by rising seed
 * @param meanKMin the mean over the repeats of k_min, by step
 * @param levels each repeat's mean of k_min in {@link PartMeans equal parts} of the run: what
 *     intervals over time are made of
 */
public record CaseResult(RunPlan plan, List<ScoredRun> runs, double[] meanKMin, double[][] levels) {
  /** The figures that the case has. */
  List<Score> scores() {
    List<Score> scores = new ArrayList<>(Score.ALL);
    if (runs.get(0).result().proof().isPresent()) {
      scores.addAll(Score.ofProofs(plan.objective()));
    }
    Metric.measured(runs.get(0).result()).stream()
        .filter(Metric::ofChance)
        .map(Score::of)
        .forEach(scores::add);
    if (runs.get(0).bestFixed().isPresent()) {
      scores.addAll(isOptimum() ? Score.OF_ADAPTING : List.of(Score.OVER_BEST_FIXED));
    }
    return scores;
  }

  /** Whether this is the exact optimum that the others are measured by. */
  public boolean isOptimum() {
    return plan.policy().equals(Yardsticks.OPTIMAL);
  }

  /** What is proven of all runs together. */
  public Proof proof() {
    return RunResult.proofOf(runs.stream().map(ScoredRun::result).toList());
  }

  /** What is known of a figure. */
  public SeedValues values(Score score) {
    return new SeedValues(figures(score));
  }

  /** One figure of every run, NaN where there is none. */
  public double[] figures(Score score) {
    return runs.stream().mapToDouble(score::of).toArray();
  }
}
