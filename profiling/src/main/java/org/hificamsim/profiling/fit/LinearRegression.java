package org.hificamsim.profiling.fit;

import java.util.List;
import java.util.Locale;
import org.hificamsim.hifi.feature.LinearAbstraction;

/** Multiple linear regression of {@code -log10(PIP)} on z, q and d (thesis 4.5.1). */
public final class LinearRegression implements FeatureRegression {
  @Override
  public String name() {
    return "lin";
  }

  @Override
  public FittedFeature fit(List<Observation> observations) {
    double[][] x = observations.stream().map(Observation::predictors).toArray(double[][]::new);
    double[] y = observations.stream().mapToDouble(Observation::response).toArray();
    List<Coefficient> fit = LeastSquares.fit(x, y, List.of("q", "d", "z"));
    LinearAbstraction f =
        new LinearAbstraction(
            fit.get(3).value(), fit.get(1).value(), fit.get(2).value(), fit.get(0).value());
    return new FittedFeature(f, equation(f), fit);
  }

  /** The equation as Eq 4.4 prints it. */
  static String equation(LinearAbstraction f) {
    return String.format(
        Locale.ROOT,
        "-log10(PIP) = %s z %+.4g q %+.4g d %+.4g",
        LeastSquares.shown(f.z()),
        f.q(),
        f.d(),
        f.intercept());
  }
}
