package org.hificamsim.runs.compare;

import org.hificamsim.runs.RunResult;

/**
 * A run beside the exact optimum of the same scenario, detection model and seed.
 *
 * @param optimum the performance of the exact per-step optimum
 * @param settling steps until the run is within 90% of its final level ({@link Settling}); NaN
 *     where it ends at 0
 */
public record ScoredRun(RunResult result, long optimum, double settling) {
  /** Performance over that of the optimum; NaN where the optimum is 0. */
  public double proportionOfOptimal() {
    return optimum == 0 ? Double.NaN : (double) result.performance() / optimum;
  }

  /** What is lost against the optimum, in the unit of performance. */
  public long regret() {
    return optimum - result.performance();
  }
}
