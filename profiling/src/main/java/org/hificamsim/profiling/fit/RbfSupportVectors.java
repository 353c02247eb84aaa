package org.hificamsim.profiling.fit;

import java.util.List;
import java.util.Locale;
import java.util.function.ToDoubleFunction;
import org.hificamsim.core.InputException;
import org.hificamsim.hifi.feature.SvrRbfAbstraction;
import org.hificamsim.hifi.feature.SvrRbfAbstraction.Range;
import smile.math.kernel.GaussianKernel;
import smile.regression.KernelMachine;

/**
 * Epsilon support vector regression with a radial basis function kernel (Eq 4.10) on q, d and z
 * scaled to [0, 1], gamma being 1 over the number of variables.
 *
 * @param settings epsilon, C and tolerance
 */
public record RbfSupportVectors(SupportVectorSettings settings) implements FeatureRegression {
  private static final double GAMMA = 1.0 / 3;

  /** So wide that the kernel does not see the variable: there is nothing to learn about it. */
  private static final Range NO_EFFECT = new Range(0, 1000);

  @Override
  public String name() {
    return "svr-rbf";
  }

  @Override
  public FittedFeature fit(List<Observation> observations) {
    SvrRbfAbstraction f = abstraction(observations, machine(observations));
    return new FittedFeature(
        f,
        String.format(
            Locale.ROOT,
            "no closed form: %d support vectors of %d rows, gamma %.4g",
            f.support().length,
            observations.size(),
            f.gamma()),
        List.of());
  }

  /** Smile's own machine on the scaled variables. */
  KernelMachine<double[]> machine(List<Observation> observations) {
    double[][] x = scaled(observations);
    if (LeastSquares.varying(x, 3).length == 0) {
      throw new InputException(
          x.length + " rows do not determine a fit, expected several values of q, d or z");
    }
    double[] y = observations.stream().mapToDouble(Observation::response).toArray();
    return settings.fit(new GaussianKernel(StrictMath.sqrt(1 / (2 * GAMMA))), x, y);
  }

  /** The scaled predictors of every observation. */
  static double[][] scaled(List<Observation> observations) {
    Range q = range(observations, Observation::size);
    Range d = range(observations, Observation::distance);
    Range z = range(observations, Observation::focalLength);
    return observations.stream()
        .map(o -> new double[] {q.scale(o.size()), d.scale(o.distance()), z.scale(o.focalLength())})
        .toArray(double[][]::new);
  }

  /** The machine as a model that needs no library; each support vector is found by its place. */
  static SvrRbfAbstraction abstraction(
      List<Observation> observations, KernelMachine<double[]> machine) {
    double[][] x = scaled(observations);
    double[][] vectors = machine.instances();
    double[][] support = new double[vectors.length][];
    for (int i = 0; i < vectors.length; i++) {
      Observation o = observations.get(index(x, vectors[i]));
      support[i] = new double[] {o.size(), o.distance(), o.focalLength(), machine.weights()[i]};
    }
    return new SvrRbfAbstraction(
        GAMMA,
        machine.intercept(),
        range(observations, Observation::size),
        range(observations, Observation::distance),
        range(observations, Observation::focalLength),
        support);
  }

  private static int index(double[][] x, double[] vector) {
    for (int i = 0; i < x.length; i++) {
      if (java.util.Arrays.equals(x[i], vector)) {
        return i;
      }
    }
    throw new IllegalStateException("a support vector that is no observation");
  }

  private static Range range(
      List<Observation> observations, ToDoubleFunction<Observation> variable) {
    double least = observations.stream().mapToDouble(variable).min().orElseThrow();
    double most = observations.stream().mapToDouble(variable).max().orElseThrow();
    if (most == least) {
      return NO_EFFECT;
    }
    return new Range(least, most);
  }
}
