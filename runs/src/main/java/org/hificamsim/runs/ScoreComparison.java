package org.hificamsim.runs;

/**
 * Compares the score of a run with the scores of the yardsticks, which have the same scenario,
 * detection model and seed.
 *
 * @param score the score of the run: its performance, unless the objective is another
 * @param optimum the score of the exact optimum of each step; NaN if it was not run
 * @param bound a bound that no score exceeds; NaN if it was not asked for
 * @param bestFixed the score of the best configuration that never changes; NaN if it was not run
 * @param reachableBound a bound that no policy exceeds if its moves take time; NaN if it was not
 *     asked for
 * @param settling the steps until the run is within 90% of its final level; NaN if that is 0
 */
record ScoreComparison(
    double score,
    double optimum,
    double bound,
    double bestFixed,
    double reachableBound,
    double settling) {
  /** The score divided by that of the optimum; NaN if the latter is 0. */
  double proportionOfOptimal() {
    return optimum == 0 ? Double.NaN : score / optimum;
  }

  /**
   * The score divided by the bound, which is a lower limit of {@link #proportionOfOptimal}; NaN if
   * the bound is 0.
   */
  double proportionOfBound() {
    return bound == 0 ? Double.NaN : score / bound;
  }

  /** The score divided by the reachable bound; NaN if the latter is 0. */
  double proportionOfReachable() {
    return reachableBound == 0 ? Double.NaN : score / reachableBound;
  }

  /** The optimum's score minus the run's. */
  double regret() {
    return optimum - score;
  }

  /**
   * The score divided by that of the best fixed configuration: the value of adapting for the
   * optimum, the value of learning for another policy; NaN if the best fixed score is 0 or unknown.
   */
  double overBestFixed() {
    return bestFixed == 0 ? Double.NaN : score / bestFixed;
  }
}
