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
    return StratifiedBootstrap.of(Improvement::probability, policy, over);
  }

  /** The probability alone; both have the same scenarios in the same order. */
  static double probability(Strata policy, Strata over) {
    double[] shares = new double[policy.scores().size()];
    Arrays.setAll(shares, i -> share(policy.scores().get(i), over.scores().get(i)));
    return StatUtils.mean(Arrays.stream(shares).filter(share -> !Double.isNaN(share)).toArray());
  }

  private static double share(double[] scores, double[] others) {
    double[] sorted = others.clone();
    Arrays.sort(sorted);
    double[] rising = scores.clone();
    Arrays.sort(rising);
    double wins = 0;
    int below = 0;
    int notAbove = 0;
    for (double score : rising) {
      while (below < sorted.length && sorted[below] < score) {
        below++;
      }
      while (notAbove < sorted.length && sorted[notAbove] <= score) {
        notAbove++;
      }
      wins += (below + notAbove) / 2.0;
    }
    return wins / ((double) scores.length * others.length);
  }
}
