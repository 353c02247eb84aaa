package org.hificamsim.profiling.fit;

/**
 * How well predictions fit (Eq 4.3).
 *
 * @param mse mean squared error
 * @param r2 coefficient of determination, 1 - SSE / total sum of squares; NaN where nothing varies
 * @param rmse root of the mean squared error
 * @param sse sum of squared errors
 */
public record Scores(double mse, double r2, double rmse, double sse) {
  /** The scores of predictions. */
  public static Scores of(double[] observed, double[] predicted) {
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
    return new Scores(mse, total > 0 ? 1 - errors / total : Double.NaN, Math.sqrt(mse), errors);
  }
}
