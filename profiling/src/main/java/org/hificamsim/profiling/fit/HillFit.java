package org.hificamsim.profiling.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.hificamsim.hifi.detector.DetectorModel;
import org.hificamsim.hifi.detector.HillCurve;

/** Least squares of Hill's curve with four parameters, all but the floor above 0. */
final class HillFit implements DetectorRegression {
  static final Bounded EXPONENTS = new Bounded(0.1, 20);
  private static final double[] STARTS = {0.7, 1, 2, 4};

  @Override
  public String name() {
    return "hill";
  }

  @Override
  public DetectorModel fit(double[] pip, double[] confidence) {
    List<double[]> starts = new ArrayList<>();
    for (double half : CurveStarts.shares(pip)) {
      for (double exponent : STARTS) {
        double[] linear =
            CurveStarts.floorAndRise(
                pip, confidence, p -> gained(p, half, exponent), SaturatingFit.RISES);
        starts.add(new double[] {linear[0], linear[1], half, exponent});
      }
    }
    List<Bounded> bounds =
        Arrays.asList(null, SaturatingFit.RISES, CurveStarts.bounds(pip), EXPONENTS);
    double[] found = new CurveFit(HillFit::height, bounds, pip, confidence).from(starts);
    return new HillCurve(found[0], found[1], found[2], found[3]);
  }

  private static double height(double pip, double[] at, double[] gradient) {
    double gained = slopes(pip, at[2], at[3], at[1], gradient, 2);
    gradient[0] = 1;
    gradient[1] = gained;
    return at[0] + at[1] * gained;
  }

  /**
   * The share that is gained at a PIP, and in {@code gradient} from {@code first} on what the
   * height changes by half and exponent.
   */
  static double slopes(
      double pip, double half, double exponent, double rise, double[] gradient, int first) {
    double gained = gained(pip, half, exponent);
    double steepness = rise * gained * (1 - gained);
    gradient[first] = -steepness * exponent / half;
    gradient[first + 1] = pip > 0 ? steepness * StrictMath.log(pip / half) : 0;
    return gained;
  }

  static double gained(double pip, double half, double exponent) {
    return 1 / (1 + StrictMath.pow(half / pip, exponent));
  }
}
