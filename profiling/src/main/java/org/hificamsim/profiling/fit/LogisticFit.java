package org.hificamsim.profiling.fit;

import java.util.ArrayList;
import java.util.List;
import org.hificamsim.hifi.detector.DetectorModel;
import org.hificamsim.hifi.detector.LogisticCurve;

/** Least squares of the logistic curve in log PIP, with two parameters above 0. */
final class LogisticFit implements DetectorRegression {
  private static final double[] STARTS = {0.3, 1, 3};
  private static final double BEYOND = 1e4;

  @Override
  public String name() {
    return "logistic";
  }

  @Override
  public DetectorModel fit(double[] pip, double[] confidence) {
    List<double[]> starts = new ArrayList<>();
    for (double half : CurveStarts.shares(pip)) {
      for (double exponent : STARTS) {
        starts.add(new double[] {half, exponent});
        starts.add(new double[] {100 * half, exponent});
      }
    }
    Bounded shares = CurveStarts.bounds(pip);
    Bounded halves = new Bounded(shares.least(), BEYOND * shares.most());
    double[] found =
        new CurveFit(LogisticFit::height, List.of(halves, HillFit.EXPONENTS), pip, confidence)
            .from(starts);
    return new LogisticCurve(found[0], found[1]);
  }

  private static double height(double pip, double[] at, double[] gradient) {
    return HillFit.slopes(pip, at[0], at[1], 1, gradient, 0);
  }
}
