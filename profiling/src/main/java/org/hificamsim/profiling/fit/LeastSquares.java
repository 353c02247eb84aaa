package org.hificamsim.profiling.fit;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.apache.commons.math3.distribution.TDistribution;
import org.apache.commons.math3.exception.MathIllegalArgumentException;
import org.apache.commons.math3.stat.regression.OLSMultipleLinearRegression;
import org.hificamsim.core.InputException;

/** Ordinary least squares (Eqs 4.1 and 4.2) with standard errors and Student intervals. */
final class LeastSquares {
  private static final double UPPER_QUANTILE = 0.975;

  private LeastSquares() {}

  /**
   * The intercept, then one coefficient per column of {@code x}.
   *
   * @throws InputException when there are too few rows, or a column follows from the others
   */
  static List<Coefficient> fit(double[][] x, double[] y, List<String> names) {
    try {
      OLSMultipleLinearRegression regression = new OLSMultipleLinearRegression();
      regression.newSampleData(y, x);
      double[] values = regression.estimateRegressionParameters();
      double[] errors = regression.estimateRegressionParametersStandardErrors();
      double quantile =
          new TDistribution(y.length - values.length).inverseCumulativeProbability(UPPER_QUANTILE);
      List<Coefficient> coefficients = new ArrayList<>();
      for (int i = 0; i < values.length; i++) {
        double half = quantile * errors[i];
        coefficients.add(
            new Coefficient(
                i == 0 ? "intercept" : names.get(i - 1),
                values[i],
                errors[i],
                values[i] - half,
                values[i] + half));
      }
      return coefficients;
    } catch (MathIllegalArgumentException e) {
      throw new InputException(
          "%s rows do not determine a fit, expected several values of each of %s"
              .formatted(y.length, String.join(", ", names)),
          e);
    }
  }

  /** Four significant digits. */
  static String shown(double value) {
    return String.format(Locale.ROOT, "%.4g", value);
  }
}
