package org.hificamsim.profiling.fit;

import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import org.apache.commons.math3.stat.StatUtils;
import org.apache.commons.math3.util.MathArrays;

/**
 * Selects the simplest of several fits that is as good as the best: its mean error over the groups
 * lies within one standard error of the best one (Breiman et al. 1984).
 *
 * <p>The standard error is that of the difference between the two fits over the groups. Objects
 * differ more than fits do, so that with the standard error of the error itself a line would always
 * pass.
 */
public final class OneStandardError {
  private OneStandardError() {}

  /**
   * Returns the index of the simplest fit that is as good as the best.
   *
   * @param errors the errors of each fit in each group, the simplest fit first; may be NaN
   */
  public static int simplest(List<double[]> errors) {
    int best = best(errors);
    return IntStream.range(0, errors.size())
        .filter(i -> isAsGood(errors.get(i), errors.get(best)))
        .findFirst()
        .orElse(best);
  }

  /** Returns the index of the fit with the least mean error. */
  public static int best(List<double[]> errors) {
    return IntStream.range(0, errors.size())
        .boxed()
        .min(Comparator.comparingDouble(i -> StatUtils.mean(errors.get(i))))
        .orElseThrow();
  }

  /** Whether a fit is as good as another one, whose errors in the same groups are given. */
  public static boolean isAsGood(double[] errors, double[] best) {
    double[] differences = MathArrays.ebeSubtract(errors, best);
    return StatUtils.mean(differences)
        <= Math.sqrt(StatUtils.variance(differences) / differences.length);
  }
}
