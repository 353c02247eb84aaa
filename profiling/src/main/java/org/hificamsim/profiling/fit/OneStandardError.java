package org.hificamsim.profiling.fit;

import java.util.List;
import java.util.stream.IntStream;

/**
 * The simplest of several fits that is as good as the best: its mean error over the groups lies
 * within one standard error of the best one's (Breiman et al. 1984).
 *
 * <p>The standard error is that of the difference between the two over the groups. Objects differ
 * more from each other than fits do: by the error's own standard error a line would always be good
 * enough.
 */
final class OneStandardError {
  private OneStandardError() {}

  /**
   * Which one is chosen.
   *
   * @param errors the error in each group, the simplest fit first
   */
  static int simplest(List<double[]> errors) {
    int best = best(errors);
    return IntStream.range(0, errors.size())
        .filter(i -> asGood(errors.get(i), errors.get(best)))
        .findFirst()
        .orElse(best);
  }

  /** The one with the least mean error. */
  static int best(List<double[]> errors) {
    return IntStream.range(0, errors.size())
        .reduce((a, b) -> mean(errors.get(b)) < mean(errors.get(a)) ? b : a)
        .orElseThrow();
  }

  private static boolean asGood(double[] errors, double[] best) {
    double[] more = new double[errors.length];
    for (int i = 0; i < more.length; i++) {
      more[i] = errors[i] - best[i];
    }
    double mean = mean(more);
    double sum = 0;
    for (double value : more) {
      sum += (value - mean) * (value - mean);
    }
    return mean <= Math.sqrt(sum / (more.length - 1) / more.length);
  }

  /** Infinite where a fit has no value somewhere. */
  private static double mean(double[] values) {
    double sum = 0;
    for (double value : values) {
      sum += value;
    }
    return Double.isNaN(sum) ? Double.POSITIVE_INFINITY : sum / values.length;
  }
}
