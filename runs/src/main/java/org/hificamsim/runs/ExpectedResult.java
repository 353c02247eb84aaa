package org.hificamsim.runs;

import java.io.Serializable;
import org.hificamsim.core.engine.RunCoverage;

/**
 * What was to be expected of one repeat before luck was drawn, of the configurations that it took.
 *
 * @param performance the sum over the steps of the expected k_min
 * @param covered0 expected share of targets that no camera covers, over all steps
 * @param covered1 expected share that exactly one camera covers
 * @param coveredK expected share that two or more cameras cover
 * @param meanK expected mean number of cameras that cover a target
 * @param leastK the least expected number of cameras that cover a target, mean over the steps
 * @param leastChance the least chance of a target to be covered, mean over the steps
 * @param leastKBound what leastK could have been at most; NaN under a policy that does not claim it
 *     to be the best
 */
public record ExpectedResult(
    double performance,
    double covered0,
    double covered1,
    double coveredK,
    double meanK,
    double leastK,
    double leastChance,
    double leastKBound)
    implements Serializable {
  /** Nothing was left to chance. */
  public static final ExpectedResult NONE = of(new RunCoverage(), Double.NaN);

  /**
   * Of a repeat whose coverage has been added up.
   *
   * @param gap what the least expected coverage might gain, over all steps; NaN where none is known
   */
  static ExpectedResult of(RunCoverage coverage, double gap) {
    return new ExpectedResult(
        coverage.expectedPerformance(),
        coverage.expectedProportion0(),
        coverage.expectedProportion1(),
        coverage.expectedProportionK(),
        coverage.expectedMeanK(),
        coverage.leastExpectedK(),
        coverage.leastChance(),
        coverage.leastExpectedK() + gap / Math.max(1, coverage.steps()));
  }
}
