package org.hificamsim.profiling.fit;

import java.util.List;
import java.util.Locale;
import org.hificamsim.hifi.feature.PowerLawAbstraction;

/** The power law {@code PIP = c z^a q^b d^-e} by least squares of the logarithms. */
public final class PowerRegression implements FeatureRegression {
  @Override
  public String name() {
    return "power";
  }

  @Override
  public FittedFeature fit(List<Observation> observations) {
    double[][] x = observations.stream().map(PowerRegression::logarithms).toArray(double[][]::new);
    double[] y = observations.stream().mapToDouble(o -> -o.response()).toArray();
    List<Coefficient> fit = LeastSquares.fit(x, y, List.of("log10 q", "log10 d", "log10 z"));
    double c = StrictMath.pow(10, fit.get(0).value());
    PowerLawAbstraction f =
        new PowerLawAbstraction(c, fit.get(3).value(), fit.get(1).value(), -fit.get(2).value());
    String equation =
        String.format(
            Locale.ROOT,
            "PIP = %s z^%.3f q^%.3f d^%.3f",
            LeastSquares.shown(c),
            f.a(),
            f.b(),
            -f.e());
    return new FittedFeature(f, equation, fit);
  }

  private static double[] logarithms(Observation o) {
    return new double[] {
      StrictMath.log10(o.size()), StrictMath.log10(o.distance()), StrictMath.log10(o.focalLength())
    };
  }
}
