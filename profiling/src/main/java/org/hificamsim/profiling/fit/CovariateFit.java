package org.hificamsim.profiling.fit;

import java.util.Arrays;
import java.util.List;
import org.hificamsim.hifi.detector.DetectorModel;
import org.hificamsim.profiling.dataset.Covariate;
import org.hificamsim.profiling.measure.Measurement;

/**
 * What something else than PIP does to a detector's confidence: {@code g(PIP exp(weight (x -
 * mean)))}.
 *
 * @param weight logarithm of the share per unit of the covariate, with 95% intervals as those of
 *     {@link RisingSlope}, by the curve's slope where it was found
 * @param without R2 of g alone on what it has not seen
 * @param with the same with the covariate
 * @param helps whether the error there is less by more than a standard error
 */
public record CovariateFit(
    Covariate covariate, RisingSlope weight, double without, double with, boolean helps) {
  private static final double STEP = 1e-4; // of the logarithm of the share

  /** One for each covariate that every photo has and that varies; about g on measured PIP. */
  public static List<CovariateFit> all(FitResult result, String detector) {
    List<Covariate> known = CovariateChoice.known(result.measurements());
    if (known.isEmpty()) {
      return List.of();
    }
    double[] y = result.confidences(detector);
    ShapeFit alone = alone(result, detector, y);
    return known.stream().map(covariate -> of(result, covariate, alone, y)).toList();
  }

  /** The chosen shape without any covariate. */
  private static ShapeFit alone(FitResult result, String detector, double[] y) {
    ShapeFit chosen = result.model(detector, FitResult.GROUND_TRUTH).chosen();
    if (result.shifts(detector).all().terms().isEmpty()) {
      return chosen;
    }
    double[][] same = new double[result.unseen().count()][];
    Arrays.fill(same, result.measuredPip());
    DetectorRegression shape = DetectorShapes.of(chosen.shape());
    return ShapeFit.of(shape, result.measuredPip(), same, y, result.unseen());
  }

  private static CovariateFit of(
      FitResult result, Covariate covariate, ShapeFit alone, double[] y) {
    List<Measurement> photos = result.measurements();
    Groups groups = result.unseen();
    ShiftedFit fit = ShiftedFit.of(alone, List.of(covariate), photos, y, groups);
    return new CovariateFit(
        covariate,
        weight(fit, photos, y),
        alone.unseen().r2(),
        fit.g().unseen().r2(),
        fit.helpsBeside(ShiftedFit.plain(groups, alone)));
  }

  /** One step of Gauss and Newton from where the fit ended, which leaves the weight as it is. */
  private static RisingSlope weight(ShiftedFit fit, List<Measurement> photos, double[] y) {
    Shift.Term term = fit.shifts().all().terms().get(0);
    double[] pip = photos.stream().mapToDouble(Measurement::pip).toArray();
    double[] x = fit.shifts().all().applied(pip, photos);
    double[] values = ShiftFitting.values(term.covariate(), photos);
    DetectorModel g = fit.g().g();
    double[] slopes = new double[y.length];
    double[] heights = new double[y.length];
    for (int i = 0; i < y.length; i++) {
      double rise = g.confidence(x[i] * (1 + STEP)) - g.confidence(x[i] * (1 - STEP));
      slopes[i] = rise / (2 * STEP) * (values[i] - term.mean());
      heights[i] = y[i] - g.confidence(x[i]) + term.weight() * slopes[i];
    }
    RisingSlope interval = RisingSlope.plain(slopes, heights, Groups.byObject(photos), 0);
    return new RisingSlope(term.weight(), interval.low(), interval.high(), interval.sure());
  }
}
