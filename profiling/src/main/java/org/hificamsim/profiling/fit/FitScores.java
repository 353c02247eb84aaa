package org.hificamsim.profiling.fit;

import java.util.Arrays;

/**
 * Scores of predictions (Eq 4.3).
 *
 * @param mse mean squared error
 * @param r2 coefficient of determination, 1 - SSE / total sum of squares; NaN if the observations
 *     do not vary
 * @param rmse root of the mean squared error
 * @param sse sum of squared errors
 */
public record FitScores(double mse, double r2, double rmse, double sse) {
  /** Computes the scores of predictions. */
  public static FitScores of(double[] observed, double[] predicted) {
    double mean = 0;
    for (double value : observed) {
      mean += value / observed.length;
    }
    double errors = 0;
    double total = 0;
    for (int i = 0; i < observed.length; i++) {
      double error = observed[i] - predicted[i];
      errors += error * error;
      total += (observed[i] - mean) * (observed[i] - mean);
    }
    double mse = errors / observed.length;
    double r2 = vary(observed) ? 1 - errors / total : Double.NaN;
    return new FitScores(mse, r2, Math.sqrt(mse), errors);
  }

  /**
   * Whether values differ. Their variance is no test, since rounding may make it positive for equal
   * values.
   */
  static boolean vary(double[] values) {
    return Arrays.stream(values).anyMatch(value -> value != values[0]);
  }
}
