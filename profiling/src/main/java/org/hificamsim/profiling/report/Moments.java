package org.hificamsim.profiling.report;

import org.apache.commons.math3.stat.StatUtils;
import org.apache.commons.math3.stat.descriptive.moment.StandardDeviation;

/**
 * What Table 4.1 says of a variable.
 *
 * @param skewness by thesis 4.2's formula, {@code sum (x - mean)^3 / ((n - 1) v^(3/2))}; its
 *     exponent is printed as 2/3
 */
record Moments(double mean, double sd, double min, double max, double skewness) {
  static Moments of(double[] values) {
    double mean = StatUtils.mean(values);
    double sd = new StandardDeviation().evaluate(values);
    double cubes = 0;
    for (double value : values) {
      cubes += StrictMath.pow(value - mean, 3);
    }
    double skewness = sd > 0 ? cubes / ((values.length - 1) * sd * sd * sd) : 0;
    return new Moments(mean, sd, StatUtils.min(values), StatUtils.max(values), skewness);
  }
}
