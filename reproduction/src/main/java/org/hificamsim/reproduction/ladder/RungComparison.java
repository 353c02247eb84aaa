package org.hificamsim.reproduction.ladder;

import org.apache.commons.math3.stat.correlation.KendallsCorrelation;

/**
 * A rung compared with the top rung in one scenario; figures are of the seeds that a bootstrap
 * draws.
 */
record RungComparison(PolicyScores own, PolicyScores top) {
  /**
   * How alike both put the policies in order: Kendall's tau-b, 1 for the same order, -1 for the
   * reverse; NaN where either has all policies tie.
   */
  double tau(int[] seeds) {
    return new KendallsCorrelation().correlation(own.means(seeds), top.means(seeds));
  }

  /**
   * The score that is lost under the top rung by choosing the policy that is best under this one, 0
   * or more; where several are, what is lost on average by choosing any of them. Other seeds may
   * lead to another choice.
   */
  double regret(int[] seeds) {
    return best(seeds) - top.mean(own.best(seeds), seeds);
  }

  /** The regret as a share of the top rung's best; NaN where that is 0. */
  double share(int[] seeds) {
    double best = best(seeds);
    return best == 0 ? Double.NaN : regret(seeds) / best;
  }

  private double best(int[] seeds) {
    return top.mean(top.best(seeds), seeds);
  }
}
