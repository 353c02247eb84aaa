package org.hificamsim.runs;

import java.util.Arrays;
import java.util.regex.Pattern;
import org.apache.commons.math3.distribution.TDistribution;
import org.apache.commons.math3.stat.StatUtils;
import org.apache.commons.math3.stat.descriptive.moment.Skewness;
import org.apache.commons.math3.stat.descriptive.moment.StandardDeviation;
import org.hificamsim.core.Texts;

/**
 * A value with its 95% interval. All intervals of means over seeds are computed here, by Student's
 * quantiles. From {@link #ENOUGH_SEEDS} seeds, the interval reaches farther on the side where
 * values scatter more: Student's quantiles hold for a cubic polynomial of the t statistic that has
 * no skewness, and are transformed back (Hall, On the Removal of Skewness by Transformation, 1992).
 * The standard error and skewness of a mean come from its values, those of other figures from the
 * draws of a bootstrap.
 *
 * @param mean the mean of runs, or another figure; NaN if there is none
 * @param low the lower end of the interval; NaN if there is none
 * @param high the upper end; NaN if there is none
 */
public record Estimate(double mean, double low, double high) {
  /**
   * The number of seeds that a conclusion needs. With fewer, an interval is wide, another seed may
   * change the conclusion, and the skewness of values is due to chance.
   */
  public static final int ENOUGH_SEEDS = 10;

  private static final double LEVEL = 0.95;

  /**
   * The most by which the longer side of an interval may exceed that of Student's interval. One
   * outlier among ten seeds would otherwise make it three times as long, beyond the values of all
   * seeds; with this limit, intervals of exponential scores still cover 93 % of the means.
   */
  private static final double LONGEST_SIDE = 1.75;

  /** The skewness below which rounding would change an interval more than the skewness does. */
  private static final double NO_SKEWNESS = 1e-6;

  /** The minus sign of a number that is printed as 0. */
  private static final Pattern MINUS_OF_ZERO = Pattern.compile("-(?=0(\\.0*)?(?![.\\d]))");

  /**
   * The mean of values. NaN is left out; a single value has no interval.
   *
   * @return NaN for mean and interval if no value is left
   */
  public static Estimate mean(double[] values) {
    double[] known = known(values);
    if (known.length <= 1) { // the usual case of a run, in which no statistics have to be loaded
      return single(known.length == 0 ? Double.NaN : known[0]);
    }
    double root = Math.sqrt(known.length);
    double skewness = known.length < ENOUGH_SEEDS ? 0 : skewness(known) / root;
    double error = new StandardDeviation().evaluate(known) / root;
    return around(StatUtils.mean(known), error, skewness, known.length - 1);
  }

  /** The mean difference of paired values. */
  public static Estimate difference(double[] values, double[] paired) {
    return mean(differences(values, paired));
  }

  /** The differences of paired values that are both known. */
  public static double[] differences(double[] values, double[] paired) {
    double[] differences = new double[values.length];
    Arrays.setAll(differences, i -> values[i] - paired[i]);
    return known(differences);
  }

  /** The values that are not NaN. */
  public static double[] known(double[] values) {
    return Arrays.stream(values).filter(value -> !Double.isNaN(value)).toArray();
  }

  /** A value without an interval, such as that of a single run. */
  public static Estimate single(double value) {
    return new Estimate(value, Double.NaN, Double.NaN);
  }

  /**
   * A value with an interval from the draws of a bootstrap. The variance of draws is smaller than
   * that of new seeds by the factor (n - 1) / n; it is corrected, so that a mean gets nearly the
   * same interval as without a bootstrap.
   *
   * @param drawn the values of the draws, none of them NaN; if empty, there is no interval
   * @param seeds the number of seeds in all groups
   * @param groups the number of groups, within each of which seeds were drawn
   */
  public static Estimate drawn(double value, double[] drawn, int seeds, int groups) {
    if (Double.isNaN(value) || drawn.length == 0) {
      return single(value);
    }
    double n = (double) seeds / groups;
    double error = Math.sqrt(n / (n - 1)) * new StandardDeviation().evaluate(drawn);
    double skewness = n < ENOUGH_SEEDS ? 0 : skewness(drawn);
    return around(value, error, Math.max(-1, Math.min(1, skewness)), seeds - groups);
  }

  /**
   * The skewness of values as those of a population, which Hall's transformation expects; 0 if they
   * are all equal, or fewer than three.
   */
  public static double skewness(double[] values) {
    int n = values.length;
    if (n < 3) {
      return 0;
    }
    Skewness skewness = new Skewness();
    skewness.incrementAll(values);
    return skewness.getResult() * (n - 2) / Math.sqrt(n * (n - 1.0));
  }

  /**
   * A value with the interval that follows from its standard error.
   *
   * @param error the standard error of the value
   * @param skewness the skewness of the distribution of the value, -1 to 1 as for any mean; 0 for
   *     Student's interval
   * @param freedom the degrees of freedom, 1 or more
   */
  public static Estimate around(double value, double error, double skewness, int freedom) {
    double t = new TDistribution(freedom).inverseCumulativeProbability((1 + LEVEL) / 2);
    return new Estimate(
        value, value - error * quantile(t, skewness), value - error * quantile(-t, skewness));
  }

  /** The quantile of a skewed t statistic by that of a symmetric one, Student's. */
  private static double quantile(double t, double skewness) {
    if (Math.abs(skewness) < NO_SKEWNESS) {
      return t;
    }
    double skewed = 3 / skewness * (Math.cbrt(1 + skewness * (t - skewness / 6)) - 1);
    double longest = LONGEST_SIDE * Math.abs(t);
    return Math.max(-longest, Math.min(longest, skewed));
  }

  /** The same estimate with its interval cut to the range of the figure. */
  public Estimate within(double least, double most) {
    return new Estimate(mean, Math.max(least, low), Math.min(most, high));
  }

  /** Returns one minus the estimate. */
  public Estimate complement() {
    return new Estimate(1 - mean, 1 - high, 1 - low);
  }

  /** The same estimate multiplied by a factor. */
  public Estimate times(double factor) {
    return new Estimate(factor * mean, factor * low, factor * high);
  }

  /** The same estimate plus a known number. */
  public Estimate plus(double known) {
    return new Estimate(mean + known, low + known, high + known);
  }

  /** Whether there were several seeds, and all of them gave this value. */
  public boolean isTheSameInEverySeed() {
    return low == mean && high == mean;
  }

  /**
   * The value with its interval in brackets if it has one, or with "in every seed" if all seeds
   * gave it; a dash if there is no value.
   *
   * @param format the format of each number
   */
  public String text(String format) {
    String pattern = format;
    if (isTheSameInEverySeed()) {
      pattern += " in every seed";
    } else if (!Double.isNaN(low)) {
      pattern += " [" + format + ", " + format + "]";
    }
    return Double.isNaN(mean)
        ? "-"
        : MINUS_OF_ZERO.matcher(Texts.format(pattern, mean, low, high)).replaceAll("");
  }
}
