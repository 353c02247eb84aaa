package org.hificamsim.profiling.fit;

import java.util.Arrays;
import java.util.List;
import org.hificamsim.core.InputException;
import org.hificamsim.hifi.detector.DetectorLine;

/**
 * A detector line g fitted by least squares, confidence on PIP (thesis 5.4, thesis 6.1).
 *
 * @param slope the slope with its error and interval
 * @param intercept the intercept with its error and interval
 * @param r2 the share of the confidences' variance that the line explains
 * @param rmse root of SSE over its degrees of freedom, n - 2
 * @param sse sum of squared errors
 */
public record LineFit(
    Coefficient slope, Coefficient intercept, double r2, double rmse, double sse) {
  /**
   * Fits a line, which is horizontal through the mean if {@code x} does not vary.
   *
   * @throws InputException when there are fewer than three points
   */
  public static LineFit of(double[] x, double[] y) {
    if (x.length < 3) {
      throw new InputException(x.length + " rows, expected three or more for a line");
    }
    double first = x[0];
    if (Arrays.stream(x).allMatch(value -> value == first)) {
      return horizontal(y);
    }
    double[][] rows =
        Arrays.stream(x).mapToObj(value -> new double[] {value}).toArray(double[][]::new);
    List<Coefficient> fit = LeastSquares.fit(rows, y, List.of("slope"));
    double[] fitted =
        Arrays.stream(x).map(value -> fit.get(0).value() + fit.get(1).value() * value).toArray();
    return of(fit.get(1), fit.get(0), FitScores.of(y, fitted));
  }

  /** Returns the line without errors and scores. */
  public DetectorLine line() {
    return new DetectorLine(slope.value(), intercept.value());
  }

  private static LineFit horizontal(double[] y) {
    double[] mean = new double[y.length];
    Arrays.fill(mean, Arrays.stream(y).average().orElseThrow());
    return of(
        Coefficient.withoutError("slope", 0),
        Coefficient.withoutError("intercept", mean[0]),
        FitScores.of(y, mean));
  }

  private static LineFit of(Coefficient slope, Coefficient intercept, FitScores scores) {
    double points = scores.sse() / scores.mse();
    double rmse = scores.sse() == 0 ? 0 : Math.sqrt(scores.sse() / (points - 2));
    return new LineFit(slope, intercept, scores.r2(), rmse, scores.sse());
  }
}
