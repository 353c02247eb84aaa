package org.hificamsim.profiling.fit;

import java.util.List;
import org.apache.commons.math3.stat.StatUtils;
import org.apache.commons.math3.stat.descriptive.moment.StandardDeviation;
import org.hificamsim.profiling.measure.Measurement;

/**
 * A validation of f: every photo is predicted by a fit that has not seen it, nor the others of its
 * group (thesis 4.4 with folds for groups).
 *
 * @param fits the fit that has not seen each group
 * @param folds the R2 within each group
 * @param predicted the held-out prediction of each photo's {@code -log10(PIP)}
 * @param r2 of all these predictions together
 */
public record CrossValidation(
    List<FittedFeature> fits, double[] folds, double[] predicted, double r2) {
  /** What the fits say of the groups that they have not seen. */
  static CrossValidation of(Groups groups, List<FittedFeature> fits, List<Measurement> photos) {
    double[] observed = Measurement.responses(photos);
    double[] predicted = new double[observed.length];
    double[] folds = new double[groups.count()];
    for (int group = 0; group < folds.length; group++) {
      int[] held = groups.rows().get(group);
      for (int row : held) {
        predicted[row] = fits.get(group).response(photos.get(row));
      }
      folds[group] = FitScores.of(Groups.at(held, observed), Groups.at(held, predicted)).r2();
    }
    return new CrossValidation(fits, folds, predicted, FitScores.of(observed, predicted).r2());
  }

  /** The mean of the folds' R2. */
  public double mean() {
    return StatUtils.mean(folds);
  }

  /** The standard deviation of the folds' R2. */
  public double deviation() {
    return new StandardDeviation().evaluate(folds);
  }
}
