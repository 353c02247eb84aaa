package org.hificamsim.runs.compare;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import org.apache.commons.math3.stat.StatUtils;
import org.hificamsim.runs.Estimate;

/**
 * The percentile bootstrap: 95% intervals that ask nothing of the distribution (Efron and
 * Tibshirani, An Introduction to the Bootstrap, 1993, chapter 13). Same values, same interval.
 */
public final class Bootstrap {
  private static final int RESAMPLES_OF_MEAN = 2000;
  private static final int RESAMPLES_OF_FIGURE = 1000;
  private static final long SEED = 1993;

  private Bootstrap() {}

  /**
   * The mean with its interval, of which a single value has none; values that are NaN are left out.
   *
   * @return NaN throughout where no value is left
   */
  public static Estimate mean(double[] values) {
    double[] known = known(values);
    return estimate(
        StatUtils.mean(known), known.length, RESAMPLES_OF_MEAN, seeds -> mean(known, seeds));
  }

  private static double mean(double[] values, int[] seeds) {
    double sum = 0;
    for (int seed : seeds) {
      sum += values[seed];
    }
    return sum / seeds.length;
  }

  /** The mean difference of paired values with its interval. */
  public static Estimate difference(double[] values, double[] paired) {
    return mean(differences(values, paired));
  }

  /** The differences of paired values, where both are known. */
  static double[] differences(double[] values, double[] paired) {
    double[] differences = new double[values.length];
    Arrays.setAll(differences, i -> values[i] - paired[i]);
    return known(differences);
  }

  /** The values that are not NaN. */
  static double[] known(double[] values) {
    return Arrays.stream(values).filter(value -> !Double.isNaN(value)).toArray();
  }

  /**
   * A figure of the seeds with its interval, of which a single seed has none.
   *
   * @param seeds how many there are
   * @param figure of some seeds, each given by its number, perhaps repeatedly
   */
  public static Estimate of(int seeds, ToDoubleFunction<int[]> figure) {
    double value = figure.applyAsDouble(IntStream.range(0, seeds).toArray());
    return estimate(value, seeds, RESAMPLES_OF_FIGURE, figure);
  }

  private static Estimate estimate(
      double value, int seeds, int resamples, ToDoubleFunction<int[]> figure) {
    if (seeds <= 1 || Double.isNaN(value)) {
      return Estimate.single(value);
    }
    SplittableRandom random = new SplittableRandom(SEED);
    int[] drawn = new int[seeds];
    double[] figures = new double[resamples];
    for (int i = 0; i < resamples; i++) {
      Arrays.setAll(drawn, draw -> random.nextInt(seeds));
      figures[i] = figure.applyAsDouble(drawn);
    }
    double[] known = known(figures);
    return known.length == 0 ? Estimate.single(Double.NaN) : Estimate.drawn(value, known);
  }
}
