package org.hificamsim.experiments.compare;

import java.util.List;
import org.hificamsim.experiments.run.RunPlan;

/**
 * One plan with all its runs.
 *
 * @param runs one per repeat, by rising seed
 * @param meanKMin the mean over the repeats of k_min, by step
 */
public record CaseResult(RunPlan plan, List<ScoredRun> runs, double[] meanKMin) {
  /** One figure of every run. */
  public double[] figures(Score score) {
    return runs.stream().mapToDouble(score::of).toArray();
  }
}
