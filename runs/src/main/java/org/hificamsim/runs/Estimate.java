package org.hificamsim.runs;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.apache.commons.math3.distribution.TDistribution;
import org.apache.commons.math3.stat.descriptive.SummaryStatistics;
import org.apache.commons.math3.stat.descriptive.rank.Percentile;

/**
 * A value with its 95% interval, whose ends are NaN where there is none.
 *
 * @param mean of runs, or what else is estimated; NaN where there is none
 */
public record Estimate(double mean, double low, double high) {
  private static final double LEVEL = 0.95;

  /**
   * The mean of one metric over repeats, with Student's interval; its ends equal the mean where
   * there is a single repeat.
   */
  public static Estimate of(List<RunResult> results, Metric metric) {
    return mean(results.stream().mapToDouble(result -> result.value(metric)).toArray());
  }

  /** The mean of some values, one or more, with Student's interval as above. */
  public static Estimate mean(double[] values) {
    if (values.length == 1) { // as most runs: without loading what statistics need
      return new Estimate(values[0], values[0], values[0]);
    }
    SummaryStatistics statistics = new SummaryStatistics();
    Arrays.stream(values).forEach(statistics::addValue);
    double mean = statistics.getMean();
    double quantile =
        new TDistribution(values.length - 1).inverseCumulativeProbability((1 + LEVEL) / 2);
    double half = quantile * statistics.getStandardDeviation() / Math.sqrt(values.length);
    return new Estimate(mean, mean - half, mean + half);
  }

  /** A value without an interval: what a single run gives. */
  public static Estimate single(double value) {
    return new Estimate(value, Double.NaN, Double.NaN);
  }

  /**
   * The value with its interval in brackets, if it has one; a dash where there is no value.
   *
   * @param format of each number
   */
  public String text(String format) {
    String pattern = Double.isNaN(low) ? format : format + " [" + format + ", " + format + "]";
    return Double.isNaN(mean) ? "-" : String.format(Locale.ROOT, pattern, mean, low, high);
  }

  /**
   * A value with the middle 95% of what a bootstrap has drawn for it (quantiles of type 7); without
   * an interval where there is no value, or nothing was drawn.
   */
  public static Estimate drawn(double value, double[] drawn) {
    if (Double.isNaN(value) || drawn.length == 0) {
      return single(value);
    }
    Percentile percentile = new Percentile().withEstimationType(Percentile.EstimationType.R_7);
    percentile.setData(drawn);
    return new Estimate(value, percentile.evaluate(2.5), percentile.evaluate(97.5));
  }

  /** In another unit, of which one of this is {@code factor}. */
  public Estimate times(double factor) {
    return new Estimate(factor * mean, factor * low, factor * high);
  }
}
