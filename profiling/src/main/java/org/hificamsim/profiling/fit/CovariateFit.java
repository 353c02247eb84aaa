package org.hificamsim.profiling.fit;

import java.util.Arrays;
import java.util.List;
import org.hificamsim.hifi.detector.DetectorModel;
import org.hificamsim.profiling.dataset.Covariate;
import org.hificamsim.profiling.measure.Measurement;

/**
 * What something else than PIP adds to a detector's confidence: {@code g(PIP) + weight (x - mean)}.
 *
 * @param weight confidence per unit of the covariate, with 95% intervals as those of {@link
 *     RisingSlope}
 * @param without R2 of g alone on what it has not seen
 * @param with the same with the covariate
 * @param helps whether the error there is less by more than a standard error
 */
public record CovariateFit(
    Covariate covariate, RisingSlope weight, double without, double with, boolean helps) {
  /** One for each covariate that every photo has and that varies; about g on measured PIP. */
  public static List<CovariateFit> all(FitResult result, String detector) {
    return Arrays.stream(Covariate.values())
        .filter(covariate -> varies(result, covariate))
        .map(covariate -> of(result, detector, covariate))
        .toList();
  }

  private static boolean varies(FitResult result, Covariate covariate) {
    return result.measurements().stream().allMatch(m -> m.covariates().containsKey(covariate))
        && Scores.vary(values(result, covariate));
  }

  private static double[] values(FitResult result, Covariate covariate) {
    return result.measurements().stream().mapToDouble(m -> m.covariates().get(covariate)).toArray();
  }

  private static CovariateFit of(FitResult result, String detector, Covariate covariate) {
    List<Measurement> rows = result.measurements();
    double[] x = values(result, covariate);
    double[] y = result.confidences(detector);
    double[] pip = result.measuredPip();
    ShapeFit alone = result.model(detector, FitResult.GROUND_TRUTH).chosen();
    Groups groups = result.unseen();
    double[] predicted = new double[y.length];
    double[] errors = new double[groups.count()];
    for (int group = 0; group < errors.length; group++) {
      int[] held = groups.rows().get(group);
      Added added = Added.to(alone.shape(), groups.others(group), pip, x, y);
      for (int row : held) {
        predicted[row] = added.confidence(pip[row], x[row]);
      }
      errors[group] = Scores.of(Groups.at(held, y), Groups.at(held, predicted)).mse();
    }
    double[] residuals = new double[y.length];
    Arrays.setAll(residuals, i -> y[i] - alone.g().confidence(pip[i]));
    return new CovariateFit(
        covariate,
        RisingSlope.plain(x, residuals, Groups.byObject(rows), 0),
        alone.unseen().r2(),
        Scores.of(y, predicted).r2(),
        OneStandardError.simplest(List.of(alone.groupErrors(), errors)) == 1);
  }

  /** A g and what is added to it. */
  private record Added(DetectorModel g, double weight, double mean) {
    /** Of some rows. */
    static Added to(String shape, int[] rows, double[] pip, double[] x, double[] y) {
      double[] own = Groups.at(rows, x);
      DetectorModel g = DetectorShapes.of(shape).fit(Groups.at(rows, pip), Groups.at(rows, y));
      double[] residuals = new double[rows.length];
      Arrays.setAll(residuals, i -> y[rows[i]] - g.confidence(pip[rows[i]]));
      double weight = Scores.vary(own) ? LineFit.of(own, residuals).slope().value() : 0;
      return new Added(g, weight, Arrays.stream(own).average().orElseThrow());
    }

    double confidence(double pip, double x) {
      return g.confidence(pip) + weight * (x - mean);
    }
  }
}
