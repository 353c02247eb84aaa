package org.hificamsim.profiling.check;

import java.util.List;
import org.apache.commons.math3.stat.StatUtils;
import org.hificamsim.core.Spelling;

/**
 * The errors of predictions in a band of distances, as shares of the measured sizes.
 *
 * @param from the least distance of the band, in metres
 * @param to the distance at which the next band begins, in metres
 * @param boxes the number of boxes
 * @param median the median of the absolute errors
 * @param ninety the absolute error that nine in ten boxes do not exceed
 * @param bias the mean error; above 0 if the predictions are too large
 */
public record ErrorSummary(
    String rung,
    String quantity,
    double from,
    double to,
    int boxes,
    double median,
    double ninety,
    double bias) {
  static ErrorSummary of(
      SizeModel rung,
      BoxQuantity quantity,
      double from,
      double to,
      List<BoxComparison> comparisons) {
    double[] errors = comparisons.stream().mapToDouble(box -> box.error(rung, quantity)).toArray();
    double[] sizes =
        comparisons.stream().mapToDouble(box -> Math.abs(box.error(rung, quantity))).toArray();
    return new ErrorSummary(
        Spelling.of(rung),
        Spelling.of(quantity),
        from,
        to,
        errors.length,
        StatUtils.percentile(sizes, 50),
        StatUtils.percentile(sizes, 90),
        StatUtils.mean(errors));
  }
}
