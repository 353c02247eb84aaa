package org.hificamsim.runs.compare;

import java.util.OptionalDouble;
import org.hificamsim.runs.RunResult;

/**
 * A run beside the exact optimum of the same scenario, detection model and seed.
 *
 * @param optimum the score of the exact per-step optimum; the score is the performance by default
 * @param bestFixed the score of the best configuration that never changes, where it was run
 * @param settling steps until the run is within 90% of its final level ({@link Settling}); NaN
 *     where it ends at 0
 */
public record ScoredRun(
    RunResult result, double optimum, OptionalDouble bestFixed, double settling) {
  /** A run without the best fixed configuration beside it. */
  public ScoredRun(RunResult result, double optimum, double settling) {
    this(result, optimum, OptionalDouble.empty(), settling);
  }

  /** Score over that of the optimum; NaN where the optimum is 0. */
  public double proportionOfOptimal() {
    return optimum == 0 ? Double.NaN : result.score() / optimum;
  }

  /** What is lost against the optimum, in the unit of the score. */
  public double regret() {
    return optimum - result.score();
  }

  /**
   * Score over that of the best fixed configuration: of the optimum what adapting is worth, of
   * another policy what learning is; NaN where the latter is 0 or was not run.
   */
  public double overBestFixed() {
    double fixed = bestFixed.orElse(0);
    return fixed == 0 ? Double.NaN : result.score() / fixed;
  }
}
