package org.hificamsim.profiling.fit;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.apache.commons.math3.util.MathArrays;
import org.hificamsim.hifi.feature.PowerLawAbstraction;

/**
 * The power law {@code PIP = c z^a q^b d^-e} by least squares of the logarithms. The exponent of a
 * variable that never varies, as with one object or one lens, is the pinhole camera's, 2.
 */
public final class PowerRegression implements FeatureRegression {
  private static final double[] PINHOLE = {2, -2, 2};
  private static final List<String> NAMES = List.of("log10 q", "log10 d", "log10 z");

  @Override
  public String name() {
    return "power";
  }

  @Override
  public FittedFeature fit(List<Observation> observations) {
    double[][] x = observations.stream().map(PowerRegression::logarithms).toArray(double[][]::new);
    double[] y = observations.stream().mapToDouble(o -> -o.response()).toArray();
    double[] fixed = fixed(x);
    for (int i = 0; i < y.length; i++) {
      y[i] -= MathArrays.linearCombination(fixed, x[i]);
    }
    List<Coefficient> fit = withFixed(LeastSquares.fit(x, y, NAMES), fixed);
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

  /** The pinhole camera's exponent of each column that never varies; 0 of the others. */
  private static double[] fixed(double[][] x) {
    double[] fixed = PINHOLE.clone();
    for (int varying : LeastSquares.varying(x, fixed.length)) {
      fixed[varying] = 0;
    }
    return fixed;
  }

  private static List<Coefficient> withFixed(List<Coefficient> fit, double[] fixed) {
    List<Coefficient> all = new ArrayList<>(fit);
    for (int i = 0; i < fixed.length; i++) {
      if (fixed[i] != 0) {
        all.set(1 + i, Coefficient.plain(NAMES.get(i), fixed[i]));
      }
    }
    return all;
  }

  private static double[] logarithms(Observation o) {
    return new double[] {
      StrictMath.log10(o.size()), StrictMath.log10(o.distance()), StrictMath.log10(o.focalLength())
    };
  }
}
