package org.hificamsim.profiling.fit;

import java.util.Arrays;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Texts;
import org.hificamsim.hifi.feature.LinearAbstraction;
import org.hificamsim.hifi.feature.SvrRbfAbstraction;
import org.hificamsim.hifi.feature.SvrRbfAbstraction.Range;
import org.hificamsim.profiling.fit.FitSettings.SupportVectorSettings;
import org.hificamsim.profiling.measure.Measurement;
import smile.base.svm.SVR;
import smile.math.kernel.GaussianKernel;
import smile.math.kernel.LinearKernel;
import smile.math.kernel.MercerKernel;
import smile.regression.KernelMachine;

/** Epsilon support vector regressions of {@code -log10(PIP)} (thesis 4.5.3), by Smile. */
final class SupportVectors {
  private static final List<String> VARIABLES = List.of("q", "d", "z");
  private static final double GAMMA = 1.0 / VARIABLES.size();

  /** The range of a variable that never varies, so wide that the kernel ignores it. */
  private static final Range NO_EFFECT = new Range(0, 1000);

  private SupportVectors() {}

  /**
   * Returns the regression with a linear kernel on q, d and z in metres: the coefficients of Eq
   * 4.11 have magnitudes that fit unscaled variables. Regularisation affects z most, since its
   * values are small.
   */
  static FeatureRegression linear(SupportVectorSettings settings) {
    return new FeatureRegression("svr-lin", photos -> line(photos, settings));
  }

  private static FittedFeature line(List<Measurement> photos, SupportVectorSettings settings) {
    KernelMachine<double[]> machine =
        fit(new LinearKernel(), Measurement.predictors(photos), photos, settings);
    double[] weights = new double[VARIABLES.size()];
    for (int i = 0; i < machine.instances().length; i++) {
      for (int j = 0; j < weights.length; j++) {
        weights[j] += machine.weights()[i] * machine.instances()[i][j];
      }
    }
    LinearAbstraction f =
        new LinearAbstraction(weights[2], weights[0], weights[1], machine.intercept());
    return new FittedFeature(
        f,
        FeatureRegression.equation(f),
        List.of(
            Coefficient.withoutError("intercept", f.intercept()),
            Coefficient.withoutError("q", f.q()),
            Coefficient.withoutError("d", f.d()),
            Coefficient.withoutError("z", f.z())));
  }

  /**
   * Returns the regression with a radial basis function kernel (Eq 4.10) on q, d and z scaled to
   * [0, 1]; gamma is 1 over the number of variables.
   */
  static FeatureRegression rbf(SupportVectorSettings settings) {
    return new FeatureRegression(
        "svr-rbf", photos -> fitted(photos, abstraction(photos, rbfMachine(photos, settings))));
  }

  private static FittedFeature fitted(List<Measurement> photos, SvrRbfAbstraction f) {
    String equation =
        Texts.format(
            "no closed form: %d support vectors of %d rows, gamma %.4g",
            f.support().length, photos.size(), f.gamma());
    return new FittedFeature(f, equation, List.of());
  }

  /** Fits Smile's kernel machine to the scaled variables. */
  static KernelMachine<double[]> rbfMachine(
      List<Measurement> photos, SupportVectorSettings settings) {
    double[][] x = scaled(photos);
    if (LeastSquares.varying(x, VARIABLES.size()).length == 0) {
      throw LeastSquares.undetermined(x.length, VARIABLES, null);
    }
    return fit(new GaussianKernel(StrictMath.sqrt(1 / (2 * GAMMA))), x, photos, settings);
  }

  private static KernelMachine<double[]> fit(
      MercerKernel<double[]> kernel,
      double[][] x,
      List<Measurement> photos,
      SupportVectorSettings settings) {
    if (x.length < 2) {
      throw new InputException("support vectors need 2 rows or more, not " + x.length);
    }
    return new SVR<>(kernel, settings.epsilon(), settings.penalty(), settings.tolerance())
        .fit(x, Measurement.responses(photos));
  }

  /** Returns the scaled predictors of every photo. */
  static double[][] scaled(List<Measurement> photos) {
    Range q = range(photos, Measurement::size);
    Range d = range(photos, Measurement::distance);
    Range z = range(photos, Measurement::focalLength);
    return photos.stream()
        .map(
            photo ->
                new double[] {
                  q.scale(photo.size()), d.scale(photo.distance()), z.scale(photo.focalLength())
                })
        .toArray(double[][]::new);
  }

  /**
   * Converts a machine into a model without dependencies. Support vectors are matched to photos by
   * their scaled predictors.
   */
  static SvrRbfAbstraction abstraction(List<Measurement> photos, KernelMachine<double[]> machine) {
    double[][] x = scaled(photos);
    double[][] support = new double[machine.instances().length][];
    for (int i = 0; i < support.length; i++) {
      double[] vector = machine.instances()[i];
      Measurement photo =
          photos.get(
              IntStream.range(0, x.length)
                  .filter(row -> Arrays.equals(x[row], vector))
                  .findFirst()
                  .orElseThrow());
      support[i] =
          new double[] {photo.size(), photo.distance(), photo.focalLength(), machine.weights()[i]};
    }
    return new SvrRbfAbstraction(
        GAMMA,
        machine.intercept(),
        range(photos, Measurement::size),
        range(photos, Measurement::distance),
        range(photos, Measurement::focalLength),
        support);
  }

  private static Range range(List<Measurement> photos, ToDoubleFunction<Measurement> variable) {
    double least = photos.stream().mapToDouble(variable).min().orElseThrow();
    double most = photos.stream().mapToDouble(variable).max().orElseThrow();
    return most == least ? NO_EFFECT : new Range(least, most);
  }
}
