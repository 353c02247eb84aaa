package org.hificamsim.runs.benchmark;

import java.util.Collection;
import org.apache.commons.math3.distribution.TDistribution;
import org.apache.commons.math3.stat.StatUtils;

/**
 * The difference between the claimed scores and the fresh scores of a policy, with its standard
 * error (Welch 1947: claimed and fresh scores may have different variances).
 *
 * @param difference the claimed mean minus the fresh mean
 * @param error the standard error of the difference
 * @param freedom the degrees of freedom, 1 or more
 */
record Claim(double difference, double error, int freedom) {
  /** Compares the claimed scores of a task with fresh ones. */
  static Claim of(double[] claimed, double[] fresh) {
    double variance =
        StatUtils.variance(claimed) / claimed.length + StatUtils.variance(fresh) / fresh.length;
    return new Claim(
        StatUtils.mean(claimed) - StatUtils.mean(fresh),
        Math.sqrt(variance),
        Math.max(1, claimed.length + fresh.length - 2));
  }

  /** The mean of independent claims. */
  static Claim mean(Collection<Claim> claims) {
    double count = claims.size();
    return new Claim(
        claims.stream().mapToDouble(Claim::difference).sum() / count,
        Math.sqrt(claims.stream().mapToDouble(claim -> claim.error * claim.error).sum()) / count,
        claims.stream().mapToInt(Claim::freedom).sum());
  }

  /**
   * Returns half the width of the interval of the difference.
   *
   * @param alpha the probability that chance alone makes a greater difference, in (0, 1)
   */
  double margin(double alpha) {
    return error * new TDistribution(freedom).inverseCumulativeProbability(1 - alpha / 2);
  }
}
