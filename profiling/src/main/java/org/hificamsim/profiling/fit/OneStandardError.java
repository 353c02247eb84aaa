package org.hificamsim.profiling.fit;

import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import org.apache.commons.math3.stat.StatUtils;
import org.apache.commons.math3.util.MathArrays;

/**
 * The rule of one standard error (Breiman et al. 1984): a fit is as good as the best one if its
 * mean error over the groups lies within one standard error of the best mean error.
 *
 * <p>The standard error is that of the difference between the two fits over the groups. Since
 * errors vary more between objects than between fits, the standard error of a mean error would let
 * a line pass always.
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

  /**
   * Whether a fit is as good as the best one.
   *
   * @param errors the errors of the fit in each group
   * @param best the errors of the best fit in the same groups
   */
  public static boolean isAsGood(double[] errors, double[] best) {
    double[] differences = MathArrays.ebeSubtract(errors, best);
    return StatUtils.mean(differences)
        <= Math.sqrt(StatUtils.variance(differences) / differences.length);
  }
}
