package org.hificamsim.profiling.report;

import org.apache.commons.math3.stat.descriptive.moment.StandardDeviation;

/** A kernel density estimate with Gaussian kernels and Scott's bandwidth (Figure 4.2). */
record Density(double[] x, double[] y) {
  private static final int POINTS = 200;

  static Density of(double[] values) {
    Moments moments = Moments.of(values);
    double sd = new StandardDeviation().evaluate(values);
    double width = Math.max(sd * StrictMath.pow(values.length, -0.2), 1e-9);
    double from = moments.min() - 3 * width;
    double step = (moments.max() - moments.min() + 6 * width) / (POINTS - 1);
    double[] x = new double[POINTS];
    double[] y = new double[POINTS];
    for (int i = 0; i < POINTS; i++) {
      x[i] = from + i * step;
      for (double value : values) {
        double z = (x[i] - value) / width;
        y[i] += StrictMath.exp(-z * z / 2) / (Math.sqrt(2 * Math.PI) * width * values.length);
      }
    }
    return new Density(x, y);
  }
}
