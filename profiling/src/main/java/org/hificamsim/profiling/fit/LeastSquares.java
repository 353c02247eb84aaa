package org.hificamsim.profiling.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.apache.commons.math3.distribution.TDistribution;
import org.apache.commons.math3.exception.MathIllegalArgumentException;
import org.apache.commons.math3.stat.regression.OLSMultipleLinearRegression;
import org.hificamsim.core.InputException;

/** Ordinary least squares (Eqs 4.1 and 4.2) with standard errors and Student intervals. */
public final class LeastSquares {
  private static final double UPPER_QUANTILE = 0.975;

  private LeastSquares() {}

  /**
   * Returns the intercept, then one coefficient per column of {@code x}, 0 for a column that never
   * varies.
   *
   * @throws InputException when there are too few rows, columns are linearly dependent, or none
   *     varies
   */
  public static List<Coefficient> fit(double[][] x, double[] y, List<String> names) {
    int[] varying = varying(x, names.size());
    if (varying.length == 0) {
      throw undetermined(y.length, names, null);
    }
    double[][] columns =
        Arrays.stream(x).map(row -> Groups.select(varying, row)).toArray(double[][]::new);
    List<Coefficient> found = regression(columns, y, Groups.select(varying, names), names);
    List<Coefficient> all = new ArrayList<>();
    names.forEach(name -> all.add(Coefficient.withoutError(name, 0)));
    all.add(0, found.get(0));
    for (int i = 0; i < varying.length; i++) {
      all.set(1 + varying[i], found.get(1 + i));
    }
    return all;
  }

  /** Returns the columns that vary. */
  static int[] varying(double[][] x, int columns) {
    return IntStream.range(0, columns)
        .filter(k -> Arrays.stream(x).anyMatch(row -> row[k] != x[0][k]))
        .toArray();
  }

  private static List<Coefficient> regression(
      double[][] x, double[] y, List<String> names, List<String> allNames) {
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
      throw undetermined(y.length, allNames, e);
    }
  }

  /** Returns the error for rows that do not determine a fit. */
  static InputException undetermined(int rows, List<String> names, Exception cause) {
    return InputException.of(
            "%s rows do not determine a fit, expected several values of %s",
            rows, String.join(" or ", names))
        .because(cause);
  }
}
