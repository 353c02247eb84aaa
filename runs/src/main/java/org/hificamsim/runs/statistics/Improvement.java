package org.hificamsim.runs.statistics;

import java.util.Arrays;
import org.apache.commons.math3.stat.StatUtils;
import org.hificamsim.runs.Estimate;

/**
 * The probability that a run of one policy has a higher score than a run of another in the same
 * scenario, a tie counting half (Mann and Whitney's U over the number of pairs), as the mean over
 * the scenarios. Runs are not paired by seed here.
 */
public final class Improvement {
  private Improvement() {}

  /** The probability with its interval; NaN where no scenario has runs of both. */
  public static Estimate estimate(Strata policy, Strata over) {
    return Bootstrap.of(Improvement::probability, policy, over).within(0, 1);
  }

  /** The probability alone; both have the same scenarios in the same order. */
  static double probability(Strata policy, Strata over) {
    double[][] scores = policy.sortedByScenario();
    double[][] others = over.sortedByScenario();
    double[] shares = new double[scores.length];
    Arrays.setAll(shares, i -> share(scores[i], others[i]));
    return StatUtils.mean(Arrays.stream(shares).filter(share -> !Double.isNaN(share)).toArray());
  }

  /** Of one scenario, both sides' scores rising. */
  private static double share(double[] scores, double[] others) {
    double wins = 0;
    int below = 0;
    int notAbove = 0;
    for (double score : scores) {
      while (below < others.length && others[below] < score) {
        below++;
      }
      while (notAbove < others.length && others[notAbove] <= score) {
        notAbove++;
      }
      wins += (below + notAbove) / 2.0;
    }
    return wins / ((double) scores.length * others.length);
  }
}
