package org.hificamsim.runs;

import java.util.List;
import org.apache.commons.math3.distribution.TDistribution;
import org.apache.commons.math3.stat.descriptive.SummaryStatistics;

/**
 * A mean over repeats with its 95% confidence interval (Student's t).
 *
 * @param low equals the mean where there is a single repeat
 */
public record Estimate(double mean, double low, double high) {
  private static final double LEVEL = 0.95;

  /** The estimate of one metric from one result or more. */
  public static Estimate of(List<RunResult> results, Metric metric) {
    if (results.size() == 1) { // as most runs: without loading what statistics need
      double only = metric.of(results.get(0));
      return new Estimate(only, only, only);
    }
    SummaryStatistics statistics = new SummaryStatistics();
    results.forEach(result -> statistics.addValue(metric.of(result)));
    double mean = statistics.getMean();
    double quantile =
        new TDistribution(results.size() - 1).inverseCumulativeProbability((1 + LEVEL) / 2);
    double half = quantile * statistics.getStandardDeviation() / Math.sqrt(results.size());
    return new Estimate(mean, mean - half, mean + half);
  }
}
