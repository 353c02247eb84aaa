package org.hificamsim.runs;

/**
 * The score of a run next to those of the yardsticks of its comparison: of the same scenario,
 * detection model and seed.
 *
 * @param score the score of the run: its performance, unless the objective is another
 * @param optimum the score of the exact optimum of each step; NaN if it was not run
 * @param bound which no score exceeds; NaN if it was not asked for
 * @param bestFixed the score of the best configuration that never changes; NaN if it was not run
 * @param reachableBound which no policy exceeds that takes its time; NaN if it was not asked for
 * @param settling the steps until the run is within 90% of its final level; NaN if that is 0
 */
record ScoreComparison(
    double score,
    double optimum,
    double bound,
    double bestFixed,
    double reachableBound,
    double settling) {
  /** Score over that of the optimum; NaN if the optimum is 0. */
  double proportionOfOptimal() {
    return optimum == 0 ? Double.NaN : score / optimum;
  }

  /** Score over the bound: at least this share of the optimum's; NaN if the bound is 0. */
  double proportionOfBound() {
    return bound == 0 ? Double.NaN : score / bound;
  }

  /** Score over what cameras could have scored in time at most; NaN if that is 0. */
  double proportionOfReachable() {
    return reachableBound == 0 ? Double.NaN : score / reachableBound;
  }

  /** The optimum's score minus the run's. */
  double regret() {
    return optimum - score;
  }

  /**
   * Score over that of the best fixed configuration: for the optimum the value of adapting, for
   * another policy that of learning; NaN if the best fixed score is 0 or unknown.
   */
  double overBestFixed() {
    return bestFixed == 0 ? Double.NaN : score / bestFixed;
  }
}
