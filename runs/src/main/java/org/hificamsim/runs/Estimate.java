package org.hificamsim.runs;

import java.util.Arrays;
import java.util.regex.Pattern;
import org.apache.commons.math3.distribution.TDistribution;
import org.apache.commons.math3.stat.StatUtils;
import org.apache.commons.math3.stat.descriptive.moment.Skewness;
import org.apache.commons.math3.stat.descriptive.moment.StandardDeviation;
import org.hificamsim.core.Texts;

/**
 * A value with its 95% interval, whose ends are NaN where there is none. All intervals over seeds
 * are made here, by Hall (On the Removal of Skewness by Transformation, 1992) with Student's
 * quantiles: Student's interval where values lie evenly about their mean, and longer towards the
 * side where they scatter further. A mean has its standard error and skewness from its values,
 * anything else from what a bootstrap draws.
 *
 * @param mean of runs, or what else is estimated; NaN where there is none
 */
public record Estimate(double mean, double low, double high) {
  /** With fewer seeds than these, an interval is wide, and another seed may change what it says. */
  public static final int ENOUGH_SEEDS = 10;

  private static final double LEVEL = 0.95;

  /** The skewness of so few values is chance alone. */
  private static final int TOO_FEW = 3;

  /** The sign of a number that is 0 to the digits shown. */
  private static final Pattern NO_MINUS = Pattern.compile("-(?=0(\\.0*)?(?![.\\d]))");

  /** Below it, the transformation is none to the precision of its formula. */
  private static final double EVEN = 1e-6;

  /**
   * The mean of some values, of which a single one has no interval; values that are NaN are left
   * out.
   *
   * @return NaN throughout where no value is left
   */
  public static Estimate mean(double[] values) {
    double[] known = known(values);
    if (known.length <= 1) { // as most runs: without loading what statistics need
      return single(known.length == 0 ? Double.NaN : known[0]);
    }
    double root = Math.sqrt(known.length);
    double skewness = known.length > TOO_FEW ? skewness(known) / root : 0;
    double error = new StandardDeviation().evaluate(known) / root;
    return around(StatUtils.mean(known), error, skewness, known.length - 1);
  }

  /** The mean difference of paired values. */
  public static Estimate difference(double[] values, double[] paired) {
    return mean(differences(values, paired));
  }

  /** The differences of paired values, where both are known. */
  public static double[] differences(double[] values, double[] paired) {
    double[] differences = new double[values.length];
    Arrays.setAll(differences, i -> values[i] - paired[i]);
    return known(differences);
  }

  /** The values that are not NaN. */
  public static double[] known(double[] values) {
    return Arrays.stream(values).filter(value -> !Double.isNaN(value)).toArray();
  }

  /** A value without an interval: what a single run gives. */
  public static Estimate single(double value) {
    return new Estimate(value, Double.NaN, Double.NaN);
  }

  /**
   * A value with an interval from what a bootstrap has drawn for it. What is drawn scatters less
   * than what further seeds would give, by the factor (n - 1) / n in the square, and is less skew;
   * both are put right, so that a mean has the interval that it has without being drawn.
   *
   * @param drawn none is NaN; where it is empty there is no interval
   * @param seeds of all groups together
   * @param groups of seeds, each drawn again for itself
   */
  public static Estimate drawn(double value, double[] drawn, int seeds, int groups) {
    if (Double.isNaN(value) || drawn.length == 0) {
      return single(value);
    }
    double n = (double) seeds / groups;
    double error = Math.sqrt(n / (n - 1)) * new StandardDeviation().evaluate(drawn);
    double skewness = n > TOO_FEW ? Math.sqrt(n * (n - 1)) / (n - 2) * skewness(drawn) : 0;
    return around(value, error, Math.max(-1, Math.min(1, skewness)), seeds - groups);
  }

  /** 0 where all values are the same. */
  private static double skewness(double[] values) {
    Skewness skewness = new Skewness();
    skewness.incrementAll(values);
    return skewness.getResult();
  }

  /**
   * @param error its standard error
   * @param skewness of its distribution, -1 to 1 as that of any mean
   * @param freedom degrees of freedom, 1 or more
   */
  private static Estimate around(double value, double error, double skewness, int freedom) {
    double t = new TDistribution(freedom).inverseCumulativeProbability((1 + LEVEL) / 2);
    return new Estimate(
        value, value - error * skewed(t, skewness), value - error * skewed(-t, skewness));
  }

  /** What Hall's transformation makes t of. */
  private static double skewed(double t, double skewness) {
    return Math.abs(skewness) < EVEN
        ? t
        : 3 / skewness * (Math.cbrt(1 + skewness * (t - skewness / 6)) - 1);
  }

  /** The same, the interval held to what the figure can be. */
  public Estimate within(double least, double most) {
    return new Estimate(mean, Math.max(least, low), Math.min(most, high));
  }

  /** In another unit, of which one of this is {@code factor}. */
  public Estimate times(double factor) {
    return new Estimate(factor * mean, factor * low, factor * high);
  }

  /** The same, moved by a known number. */
  public Estimate plus(double known) {
    return new Estimate(mean + known, low + known, high + known);
  }

  /** Whether there were several seeds, and all of them gave this value. */
  public boolean isTheSameInEverySeed() {
    return low == mean && high == mean;
  }

  /**
   * The value with its interval in brackets, if it has one; that it is so in every seed, if it is;
   * a dash where there is no value.
   *
   * @param format of each number
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
        : NO_MINUS.matcher(Texts.format(pattern, mean, low, high)).replaceAll("");
  }
}
