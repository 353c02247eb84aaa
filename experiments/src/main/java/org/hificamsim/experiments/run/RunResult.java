package org.hificamsim.experiments.run;

import org.hificamsim.core.engine.RunCoverage;

/**
 * The coverage of one repeat.
 *
 * @param performance the sum of k_min over the steps (Eq 7.2)
 * @param meanKMin per step
 * @param covered0 share of targets that no camera covered, over all steps
 * @param covered1 share that exactly one camera covered
 * @param coveredK share that two or more cameras covered
 * @param meanK mean number of cameras that cover a target
 */
public record RunResult(
    int run,
    long seed,
    long performance,
    double meanKMin,
    double covered0,
    double covered1,
    double coveredK,
    double meanK) {
  /** The result of a repeat whose coverage has been added up. */
  public static RunResult of(int run, long seed, RunCoverage coverage) {
    return new RunResult(
        run,
        seed,
        coverage.performance(),
        coverage.meanKMin(),
        coverage.proportion0(),
        coverage.proportion1(),
        coverage.proportionK(),
        coverage.meanK());
  }
}
