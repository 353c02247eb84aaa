package org.hificamsim.profiling.report;

import java.util.List;
import java.util.function.ToDoubleFunction;
import org.apache.commons.math3.stat.StatUtils;
import org.apache.commons.math3.stat.descriptive.moment.StandardDeviation;
import org.hificamsim.profiling.fit.FitResult;
import org.hificamsim.profiling.measure.Measurement;

/** One variable of Table 4.1, with its values in all photos. */
record Variable(String id, String name, String unit, double[] values) {
  static List<Variable> of(FitResult result) {
    return List.of(
        of(result, "zoom_m", "Zoom", "(m)", Measurement::focalLength),
        of(result, "object_size_m", "Object size", "(m)", Measurement::size),
        of(result, "distance_m", "Distance", "(m)", Measurement::distance),
        of(result, "pip", "PIP", "", Measurement::pip));
  }

  private static Variable of(
      FitResult result,
      String id,
      String name,
      String unit,
      ToDoubleFunction<Measurement> variable) {
    return new Variable(
        id, name, unit, result.measurements().stream().mapToDouble(variable).toArray());
  }

  /** Returns the standard deviation. */
  static double sd(double[] values) {
    return new StandardDeviation().evaluate(values);
  }

  /**
   * Returns the skewness by the formula of thesis 4.2, {@code sum (x - mean)^3 / ((n - 1)
   * v^(3/2))}; its exponent is misprinted as 2/3.
   */
  static double skewness(double[] values) {
    double mean = StatUtils.mean(values);
    double sd = sd(values);
    double cubes = 0;
    for (double value : values) {
      cubes += StrictMath.pow(value - mean, 3);
    }
    return sd > 0 ? cubes / ((values.length - 1) * sd * sd * sd) : 0;
  }
}
