package org.hificamsim.runs.compare;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.function.ToDoubleFunction;
import org.apache.commons.math3.stat.StatUtils;
import org.hificamsim.runs.Estimate;

/**
 * The percentile bootstrap of a mean: 95% intervals that ask nothing of the distribution (Efron and
 * Tibshirani, An Introduction to the Bootstrap, 1993, chapter 13). Same values, same interval.
 */
public final class Bootstrap {
  private static final int RESAMPLES = 2000;
  private static final long SEED = 1993;

  private Bootstrap() {}

  /**
   * The mean with its interval, of which a single value has none; values that are NaN are left out.
   *
   * @return NaN throughout where no value is left
   */
  public static Estimate mean(double[] values) {
    double[] known = Arrays.stream(values).filter(value -> !Double.isNaN(value)).toArray();
    if (known.length == 0) {
      return Estimate.single(Double.NaN);
    }
    double mean = StatUtils.mean(known);
    if (known.length == 1) {
      return Estimate.single(mean);
    }
    return Estimate.drawn(mean, drawn(known.length, RESAMPLES, seeds -> mean(known, seeds)));
  }

  private static double mean(double[] values, int[] seeds) {
    double sum = 0;
    for (int seed : seeds) {
      sum += values[seed];
    }
    return sum / seeds.length;
  }

  /**
   * A figure of seeds that are drawn with replacement, again and again.
   *
   * @param seeds how many there are, and how many are drawn at a time
   */
  static double[] drawn(int seeds, int resamples, ToDoubleFunction<int[]> figure) {
    SplittableRandom random = new SplittableRandom(SEED);
    int[] drawn = new int[seeds];
    double[] figures = new double[resamples];
    for (int i = 0; i < resamples; i++) {
      Arrays.setAll(drawn, draw -> random.nextInt(seeds));
      figures[i] = figure.applyAsDouble(drawn);
    }
    return figures;
  }

  /** The mean difference of paired values with its interval. */
  public static Estimate difference(double[] values, double[] paired) {
    double[] differences = new double[values.length];
    Arrays.setAll(differences, i -> values[i] - paired[i]);
    return mean(differences);
  }
}
