package org.hificamsim.profiling.fit;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.hificamsim.core.parallel.Parallel;
import org.hificamsim.profiling.measure.Measurement;

/**
 * A feature abstraction fitted to all photos, and how it does on photos that it has not seen.
 *
 * @param name short name, such as {@code lin}
 * @param scores on all photos, of {@code -log10(PIP)}
 * @param validation fits that each left a fold out
 * @param objects fits that each left an object out, where there is more than one
 * @param lenses fits that each left a focal length out, where there is more than one
 */
public record FeatureResult(
    String name,
    FittedFeature fit,
    FitScores scores,
    CrossValidation validation,
    Optional<CrossValidation> objects,
    Optional<CrossValidation> lenses) {
  /** Fits every f to all photos, and to all but those of each fold, object and lens. */
  static List<FeatureResult> all(
      List<FeatureRegression> regressions, List<Measurement> photos, Groups folds, int threads) {
    return regressions.stream().map(one -> of(one, photos, folds, threads)).toList();
  }

  private static FeatureResult of(
      FeatureRegression regression, List<Measurement> photos, Groups folds, int threads) {
    Groups objects = Groups.byObject(photos);
    Groups lenses = Groups.byLens(photos);
    List<List<Measurement>> seen = new ArrayList<>(List.of(photos));
    Stream.of(folds, objects, lenses).forEach(groups -> seen.addAll(groups.withoutEach(photos)));
    Iterator<FittedFeature> fits = Parallel.map(seen, threads, regression::fit).iterator();
    FittedFeature all = fits.next();
    double[] predicted = photos.stream().mapToDouble(all::response).toArray();
    return new FeatureResult(
        regression.name(),
        all,
        FitScores.of(Measurement.responses(photos), predicted),
        CrossValidation.of(folds, fits, photos).orElseThrow(),
        CrossValidation.of(objects, fits, photos),
        CrossValidation.of(lenses, fits, photos));
  }

  /** Fits that have not seen the objects that they are asked of; folds where there is but one. */
  public CrossValidation unseen() {
    return objects.orElse(validation);
  }
}
