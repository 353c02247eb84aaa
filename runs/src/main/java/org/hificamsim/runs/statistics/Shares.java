package org.hificamsim.runs.statistics;

import org.apache.commons.math3.analysis.UnivariateFunction;
import org.apache.commons.math3.analysis.solvers.BrentSolver;
import org.apache.commons.math3.stat.interval.ConfidenceInterval;
import org.apache.commons.math3.stat.interval.WilsonScoreInterval;
import org.hificamsim.runs.Estimate;

/** Computes intervals of shares and probabilities, which stay within [0, 1] and are never empty. */
final class Shares {
  private static final double LEVEL = 0.95;
  private static final double NORMAL_QUANTILE = 1.959963984540054;
  private static final double PRECISION = 1e-9;
  private static final int MAX_EVALUATIONS = 200;

  private Shares() {}

  /** Estimates a share of runs; without an interval unless a scenario has two or more seeds. */
  static Estimate of(int runs, Strata strata) {
    double share = (double) runs / strata.runs();
    if (strata.freedom() <= 0) {
      return Estimate.single(share);
    }
    ConfidenceInterval ends = new WilsonScoreInterval().createInterval(strata.runs(), runs, LEVEL);
    return new Estimate(share, ends.getLowerBound(), ends.getUpperBound()).within(0, 1);
  }

  /**
   * The interval of a probability of improvement by Newcombe's method 5 (Confidence Intervals for
   * an Effect Size Measure Based on the Mann-Whitney Statistic, 2006): the probabilities that
   * differ from the observed one by at most 1.96 of their own standard errors.
   *
   * @param observed the mean probability over the scenarios
   */
  static Estimate improvement(double observed, Strata policy, Strata other) {
    if (Double.isNaN(observed) || policy.freedom() + other.freedom() <= 0) {
      return Estimate.single(observed);
    }
    UnivariateFunction excess =
        truth ->
            (observed - truth) * (observed - truth)
                - NORMAL_QUANTILE * NORMAL_QUANTILE * variance(truth, policy, other);
    return new Estimate(
        observed,
        observed < PRECISION ? 0 : end(excess, 0, observed - PRECISION),
        observed > 1 - PRECISION ? 1 : end(excess, observed + PRECISION, 1));
  }

  private static double end(UnivariateFunction excess, double from, double to) {
    return new BrentSolver(PRECISION / 10).solve(MAX_EVALUATIONS, excess, from, to);
  }

  /**
   * Returns Hanley and McNeil's variance of the mean over scenarios that all have this probability.
   */
  private static double variance(double probability, Strata policy, Strata other) {
    double sum = 0;
    int scenarios = 0;
    for (int i = 0; i < policy.scores().length; i++) {
      int seeds = policy.scores()[i].length;
      int others = other.scores()[i].length;
      if (seeds > 0 && others > 0) {
        sum += variance(probability, seeds, others);
        scenarios++;
      }
    }
    return sum / scenarios / scenarios;
  }

  private static double variance(double probability, int seeds, int others) {
    double complement = 1 - probability;
    double dependence =
        ((seeds + others) / 2.0 - 1)
            * (complement / (2 - probability) + probability / (1 + probability));
    return probability * complement * (1 + dependence) / seeds / others;
  }
}
