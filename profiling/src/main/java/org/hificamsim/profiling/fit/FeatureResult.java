package org.hificamsim.profiling.fit;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.hificamsim.core.parallel.Parallel;
import org.hificamsim.profiling.measure.Measurement;

/**
 * A feature abstraction fitted to all photos, with its cross-validations.
 *
 * @param name the short name, such as {@code lin}
 * @param scores the scores for {@code -log10(PIP)} on all photos
 * @param validation the cross-validation by folds
 * @param objects the cross-validation by objects, if there is more than one
 * @param lenses the cross-validation by focal lengths, if there is more than one
 */
public record FeatureResult(
    String name,
    FittedFeature fit,
    FitScores scores,
    CrossValidation validation,
    Optional<CrossValidation> objects,
    Optional<CrossValidation> lenses) {
  /** Fits every f to all photos, and again without those of each fold, object and lens. */
  static List<FeatureResult> all(
      List<FeatureRegression> regressions, List<Measurement> photos, Groups folds, int threads) {
    return regressions.stream().map(regression -> of(regression, photos, folds, threads)).toList();
  }

  private static FeatureResult of(
      FeatureRegression regression, List<Measurement> photos, Groups folds, int threads) {
    Groups objects = Groups.byObject(photos);
    Groups lenses = Groups.byLens(photos);
    List<List<Measurement>> training = new ArrayList<>(List.of(photos));
    Stream.of(folds, objects, lenses)
        .forEach(groups -> training.addAll(groups.withoutEach(photos)));
    Iterator<FittedFeature> fits = Parallel.map(training, threads, regression::fit).iterator();
    FittedFeature onAll = fits.next();
    double[] predicted = photos.stream().mapToDouble(onAll::response).toArray();
    return new FeatureResult(
        regression.name(),
        onAll,
        FitScores.of(Measurement.responses(photos), predicted),
        CrossValidation.of(folds, fits, photos).orElseThrow(),
        CrossValidation.of(objects, fits, photos),
        CrossValidation.of(lenses, fits, photos));
  }

  /** Returns the cross-validation by objects, or by folds if there is only one object. */
  public CrossValidation unseen() {
    return objects.orElse(validation);
  }
}
