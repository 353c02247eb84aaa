package org.hificamsim.runs;

/**
 * A run compared with the yardsticks of the same scenario, detection model and seed.
 *
 * @param optimum the score of the exact per-step optimum; the score is the performance by default;
 *     NaN where it was not run
 * @param bound what no score exceeds; NaN where it was not asked for
 * @param bestFixed the score of the best configuration that never changes; NaN where it was not run
 * @param settling steps until the run is within 90% of its final level; NaN where it ends at 0
 */
public record ScoredRun(
    RunResult result, double optimum, double bound, double bestFixed, double settling) {
  /** A run with an optimum and without a bound. */
  public ScoredRun(RunResult result, double optimum, double bestFixed, double settling) {
    this(result, optimum, Double.NaN, bestFixed, settling);
  }

  /** Score over that of the optimum; NaN where the optimum is 0. */
  public double proportionOfOptimal() {
    return optimum == 0 ? Double.NaN : result.score() / optimum;
  }

  /** Score over a bound on it: at least this share of the optimum's; NaN where the bound is 0. */
  public double proportionOfBound() {
    return bound == 0 ? Double.NaN : result.score() / bound;
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
    return bestFixed == 0 ? Double.NaN : result.score() / bestFixed;
  }
}
