package org.hificamsim.profiling.fit;

import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import org.apache.commons.math3.stat.StatUtils;
import org.apache.commons.math3.util.MathArrays;

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
   * @param errors the error in each group, the simplest fit first; NaN where a fit has none
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
        .boxed()
        .min(Comparator.comparingDouble(i -> StatUtils.mean(errors.get(i))))
        .orElseThrow();
  }

  private static boolean asGood(double[] errors, double[] best) {
    double[] more = MathArrays.ebeSubtract(errors, best);
    return StatUtils.mean(more) <= Math.sqrt(StatUtils.variance(more) / more.length);
  }
}
