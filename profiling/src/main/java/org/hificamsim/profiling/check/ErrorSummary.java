package org.hificamsim.profiling.check;

import java.util.List;
import java.util.function.ToDoubleFunction;
import org.apache.commons.math3.stat.StatUtils;
import org.hificamsim.core.Spelling;
import org.hificamsim.profiling.check.Calibration.Size;
import org.hificamsim.profiling.check.RealityCheck.BoxComparison;

/**
 * How far predictions are off, as shares of what was measured.
 *
 * @param from nearest distance that it is of, metres
 * @param to the distance where the next band begins, metres
 * @param boxes how many
 * @param median of the errors' sizes
 * @param ninety nine in ten errors are of this size or less
 * @param bias the mean error; above 0 where too much is predicted
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
  /** What of a box is compared. */
  @SuppressWarnings("ImmutableEnumChecker") // without state
  enum Quantity {
    /** In pixels. */
    HEIGHT(Size::height),
    /** The share of the picture that the box fills; as a relative error that of its area. */
    PIP(Size::area);

    private final ToDoubleFunction<Size> value;

    Quantity(ToDoubleFunction<Size> value) {
      this.value = value;
    }

    double of(Size size) {
      return value.applyAsDouble(size);
    }
  }

  static ErrorSummary of(
      SizeModel rung, Quantity quantity, double from, double to, List<BoxComparison> all) {
    double[] errors = all.stream().mapToDouble(one -> one.error(rung, quantity)).toArray();
    double[] sizes = all.stream().mapToDouble(one -> Math.abs(one.error(rung, quantity))).toArray();
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
