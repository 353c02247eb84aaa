package org.hificamsim.profiling.fit;

import java.util.List;
import org.hificamsim.hifi.feature.LinearAbstraction;
import smile.math.kernel.LinearKernel;
import smile.regression.KernelMachine;

/**
 * Epsilon support vector regression with a linear kernel on q, d and z in metres, as the magnitude
 * of Eq 4.11's coefficients shows it was used (thesis 4.5.3): flatness then costs z most, whose
 * metres are few.
 *
 * @param settings epsilon, C and tolerance
 */
public record LinearSupportVectors(SupportVectorSettings settings) implements FeatureRegression {
  private static final int VARIABLES = 3;

  @Override
  public String name() {
    return "svr-lin";
  }

  @Override
  public FittedFeature fit(List<Observation> observations) {
    double[][] x = observations.stream().map(Observation::predictors).toArray(double[][]::new);
    double[] y = observations.stream().mapToDouble(Observation::response).toArray();
    KernelMachine<double[]> machine = settings.fit(new LinearKernel(), x, y);
    double[] weights = new double[VARIABLES];
    for (int i = 0; i < machine.instances().length; i++) {
      for (int j = 0; j < VARIABLES; j++) {
        weights[j] += machine.weights()[i] * machine.instances()[i][j];
      }
    }
    LinearAbstraction f =
        new LinearAbstraction(weights[2], weights[0], weights[1], machine.intercept());
    return new FittedFeature(
        f,
        LinearRegression.equation(f),
        List.of(
            Coefficient.plain("intercept", f.intercept()),
            Coefficient.plain("q", f.q()),
            Coefficient.plain("d", f.d()),
            Coefficient.plain("z", f.z())));
  }
}
