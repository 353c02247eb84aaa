package org.hificamsim.profiling.fit;

import java.util.Iterator;
import java.util.List;
import java.util.Optional;
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
  /**
   * What fits say of the groups that they have not seen; nothing where leaving one out leaves none.
   *
   * @param fits gives the fit of {@link Groups#withoutEach} for each group
   */
  static Optional<CrossValidation> of(
      Groups groups, Iterator<FittedFeature> fits, List<Measurement> photos) {
    List<FittedFeature> unseen =
        groups.withoutEach(photos).stream().map(any -> fits.next()).toList();
    if (unseen.isEmpty()) {
      return Optional.empty();
    }
    double[] observed = Measurement.responses(photos);
    double[] predicted = groups.each((group, row) -> unseen.get(group).response(photos.get(row)));
    double[] folds =
        groups.scores(observed, predicted).stream().mapToDouble(FitScores::r2).toArray();
    return Optional.of(
        new CrossValidation(unseen, folds, predicted, FitScores.of(observed, predicted).r2()));
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
