package org.hificamsim.profiling.report;

import java.util.Arrays;
import java.util.List;
import org.hificamsim.profiling.fit.Coefficient;
import org.hificamsim.profiling.fit.LeastSquares;
import org.hificamsim.profiling.fit.Observation;

/** Multiple linear regression of PIP itself, for Figure 4.3's left side. */
final class LinearOnPip {
  private LinearOnPip() {}

  static double[] predict(List<Observation> observations) {
    double[][] x = observations.stream().map(Observation::predictors).toArray(double[][]::new);
    double[] y = observations.stream().mapToDouble(Observation::pip).toArray();
    List<Coefficient> fit = LeastSquares.fit(x, y, List.of("q", "d", "z"));
    return Arrays.stream(x).mapToDouble(row -> height(fit, row)).toArray();
  }

  private static double height(List<Coefficient> fit, double[] row) {
    double sum = fit.get(0).value();
    for (int i = 0; i < row.length; i++) {
      sum += fit.get(i + 1).value() * row[i];
    }
    return sum;
  }
}
