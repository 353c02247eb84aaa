package org.hificamsim.profiling.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.hificamsim.hifi.detector.DetectorModel;
import org.hificamsim.hifi.detector.SaturatingExponential;

/** Least squares of {@code floor + rise (1 - exp(-PIP / scale))}, rise and scale above 0. */
final class SaturatingFit implements DetectorRegression {
  static final Bounded RISES = new Bounded(1e-6, 1e4);

  @Override
  public String name() {
    return "saturating-exponential";
  }

  @Override
  public DetectorModel fit(double[] pip, double[] confidence) {
    Bounded scales = CurveStarts.bounds(pip);
    List<double[]> starts = new ArrayList<>();
    for (double scale : CurveStarts.shares(pip)) {
      double[] linear =
          CurveStarts.floorAndRise(pip, confidence, p -> -StrictMath.expm1(-p / scale), RISES);
      starts.add(new double[] {linear[0], linear[1], scale});
    }
    double[] found =
        new CurveFit(SaturatingFit::height, Arrays.asList(null, RISES, scales), pip, confidence)
            .from(starts);
    return new SaturatingExponential(found[0], found[1], found[2]);
  }

  private static double height(double pip, double[] at, double[] gradient) {
    double left = StrictMath.exp(-pip / at[2]);
    gradient[0] = 1;
    gradient[1] = 1 - left;
    gradient[2] = -at[1] * left * pip / (at[2] * at[2]);
    return at[0] + at[1] * (1 - left);
  }
}
