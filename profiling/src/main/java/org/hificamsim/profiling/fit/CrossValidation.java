package org.hificamsim.profiling.fit;

import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import org.apache.commons.math3.stat.StatUtils;
import org.apache.commons.math3.stat.descriptive.moment.StandardDeviation;
import org.hificamsim.profiling.measure.Measurement;

/**
 * A cross-validation of f: every photo is predicted by a fit to the photos of the other groups
 * (thesis 4.4, where groups are folds).
 *
 * @param fits for each group, the fit without it
 * @param folds the R2 within each group
 * @param predicted the held-out prediction of each photo's {@code -log10(PIP)}
 * @param r2 the R2 of all these predictions together
 */
public record CrossValidation(
    List<FittedFeature> fits, double[] folds, double[] predicted, double r2) {
  /**
   * Evaluates fits on the groups that they have not seen; empty if there is only one group.
   *
   * @param fits supplies a fit to each list of {@link Groups#withoutEach}
   */
  static Optional<CrossValidation> of(
      Groups groups, Iterator<FittedFeature> fits, List<Measurement> photos) {
    List<FittedFeature> unseen =
        groups.withoutEach(photos).stream().map(seenPhotos -> fits.next()).toList();
    if (unseen.isEmpty()) {
      return Optional.empty();
    }
    double[] observed = Measurement.responses(photos);
    double[] predicted =
        groups.forEachRow((group, row) -> unseen.get(group).response(photos.get(row)));
    double[] folds =
        groups.scores(observed, predicted).stream().mapToDouble(FitScores::r2).toArray();
    return Optional.of(
        new CrossValidation(unseen, folds, predicted, FitScores.of(observed, predicted).r2()));
  }

  /** Returns the mean of the folds' R2. */
  public double mean() {
    return StatUtils.mean(folds);
  }

  /** Returns the standard deviation of the folds' R2. */
  public double deviation() {
    return new StandardDeviation().evaluate(folds);
  }
}
