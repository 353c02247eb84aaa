package org.hificamsim.profiling.fit;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import org.apache.commons.math3.util.MathArrays;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Texts;
import org.hificamsim.hifi.feature.LinearAbstraction;
import org.hificamsim.hifi.feature.PinholeAbstraction;
import org.hificamsim.hifi.feature.PowerLawAbstraction;
import org.hificamsim.profiling.dataset.PhotoCamera;
import org.hificamsim.profiling.measure.Measurement;

/**
 * A way to fit a feature abstraction f. To add one, add a line to {@link #all}.
 *
 * @param name the short name in model names, such as {@code lin}
 * @param method fits photos; deterministic
 */
public record FeatureRegression(String name, Function<List<Measurement>, FittedFeature> method) {
  private static final double[] PINHOLE_EXPONENTS = {2, -2, 2};
  private static final List<String> LOGARITHMS = List.of("log10 q", "log10 d", "log10 z");

  /**
   * Fits photos.
   *
   * @throws InputException when the photos do not determine a fit
   */
  public FittedFeature fit(List<Measurement> photos) {
    return method.apply(photos);
  }

  /** Returns all regressions, the simplest first. */
  static List<FeatureRegression> all(PhotoCamera camera, FitSettings settings) {
    return List.of(
        pinhole(camera),
        power(),
        linear(),
        SupportVectors.linear(settings.vectors()),
        new FeatureRegression("sr", new SymbolicRegression(settings.symbolic())::fit),
        SupportVectors.rbf(settings.vectors()));
  }

  /** Returns the pinhole camera, which fits nothing and serves for comparison. */
  private static FeatureRegression pinhole(PhotoCamera camera) {
    FittedFeature law =
        new FittedFeature(
            new PinholeAbstraction(camera.sensorWidth(), camera.sensorHeight()),
            "PIP = (z q / d)^2 / sensor area",
            List.of());
    return new FeatureRegression("pinhole", photos -> law);
  }

  /** Returns multiple linear regression of {@code -log10(PIP)} on z, q and d (thesis 4.5.1). */
  static FeatureRegression linear() {
    return new FeatureRegression("lin", FeatureRegression::line);
  }

  private static FittedFeature line(List<Measurement> photos) {
    List<Coefficient> fit =
        LeastSquares.fit(
            Measurement.predictors(photos), Measurement.responses(photos), List.of("q", "d", "z"));
    LinearAbstraction f =
        new LinearAbstraction(
            fit.get(3).value(), fit.get(1).value(), fit.get(2).value(), fit.get(0).value());
    return new FittedFeature(f, equation(f), fit);
  }

  /** Returns the equation in the form of Eq 4.4. */
  static String equation(LinearAbstraction f) {
    return Texts.format(
        "-log10(PIP) = %.4g z %+.4g q %+.4g d %+.4g", f.z(), f.q(), f.d(), f.intercept());
  }

  /**
   * Returns the power law {@code PIP = c z^a q^b d^-e} by least squares of the logarithms. A
   * variable that never varies, for example with one lens, has the exponent of the pinhole camera,
   * 2.
   */
  static FeatureRegression power() {
    return new FeatureRegression("power", FeatureRegression::powerLaw);
  }

  private static FittedFeature powerLaw(List<Measurement> photos) {
    double[][] x = photos.stream().map(FeatureRegression::logarithms).toArray(double[][]::new);
    double[] y = photos.stream().mapToDouble(photo -> -photo.response()).toArray();
    double[] fixed = fixedExponents(x);
    for (int i = 0; i < y.length; i++) {
      y[i] -= MathArrays.linearCombination(fixed, x[i]);
    }
    List<Coefficient> fit = new ArrayList<>(LeastSquares.fit(x, y, LOGARITHMS));
    for (int i = 0; i < fixed.length; i++) {
      if (fixed[i] != 0) {
        fit.set(1 + i, Coefficient.withoutError(LOGARITHMS.get(i), fixed[i]));
      }
    }
    double c = StrictMath.pow(10, fit.get(0).value());
    PowerLawAbstraction f =
        new PowerLawAbstraction(c, fit.get(3).value(), fit.get(1).value(), -fit.get(2).value());
    String equation = Texts.format("PIP = %.4g z^%.3f q^%.3f d^%.3f", c, f.a(), f.b(), -f.e());
    return new FittedFeature(f, equation, fit);
  }

  /**
   * Returns the pinhole camera's exponent for each column that never varies, and 0 for the others.
   */
  private static double[] fixedExponents(double[][] x) {
    double[] fixed = PINHOLE_EXPONENTS.clone();
    for (int varying : LeastSquares.varying(x, fixed.length)) {
      fixed[varying] = 0;
    }
    return fixed;
  }

  private static double[] logarithms(Measurement photo) {
    return new double[] {
      StrictMath.log10(photo.size()),
      StrictMath.log10(photo.distance()),
      StrictMath.log10(photo.focalLength())
    };
  }
}
