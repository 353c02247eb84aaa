package org.hificamsim.profiling.fit;

import java.util.Arrays;

/**
 * How residuals scatter between objects and within one: a random effect of the object, by the
 * moments of a one-way analysis of variance.
 *
 * @param between standard deviation of the objects' own offsets; 0 where there is one object
 * @param within standard deviation about them
 */
public record ObjectScatter(double between, double within) {
  /** Of residuals. */
  static ObjectScatter of(double[] residuals, Groups objects) {
    int rows = residuals.length;
    int count = objects.count();
    double grand = mean(residuals);
    double inside = 0;
    double outside = 0;
    double squares = 0;
    for (int[] object : objects.rows()) {
      double[] own = Groups.at(object, residuals);
      double mean = mean(own);
      inside += Arrays.stream(own).map(r -> (r - mean) * (r - mean)).sum();
      outside += own.length * (mean - grand) * (mean - grand);
      squares += (double) own.length * own.length;
    }
    double within = inside / Math.max(1, rows - count);
    double each = (rows - squares / rows) / Math.max(1, count - 1);
    double between = count > 1 ? (outside / (count - 1) - within) / each : 0;
    return new ObjectScatter(Math.sqrt(Math.max(0, between)), Math.sqrt(within));
  }

  private static double mean(double[] values) {
    return Arrays.stream(values).average().orElse(0);
  }
}
