package org.hificamsim.profiling.fit;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
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
  /** One fit that has to be made: to these photos. */
  private record Job(FeatureRegression regression, List<Measurement> photos) {
    FittedFeature fit() {
      return regression.fit(photos);
    }
  }

  /** Fits every f to all photos, and to all but those of each fold, object and lens. */
  static List<FeatureResult> all(
      List<FeatureRegression> regressions, List<Measurement> photos, Groups folds, int threads) {
    List<Groups> leftOut = List.of(folds, Groups.byObject(photos), Groups.byLens(photos));
    List<List<Measurement>> trained = new ArrayList<>(List.of(photos));
    for (Groups groups : leftOut) {
      IntStream.range(0, fits(groups))
          .forEach(group -> trained.add(Groups.at(groups.others(group), photos)));
    }
    List<Job> jobs =
        regressions.stream()
            .flatMap(regression -> trained.stream().map(some -> new Job(regression, some)))
            .toList();
    List<FittedFeature> fits = Parallel.map(jobs, threads, Job::fit);
    return IntStream.range(0, regressions.size())
        .mapToObj(
            i ->
                of(
                    regressions.get(i).name(),
                    fits.subList(i * trained.size(), (i + 1) * trained.size()),
                    leftOut,
                    photos))
        .toList();
  }

  /** How many fits groups need: none where leaving one out leaves nothing. */
  private static int fits(Groups groups) {
    return groups.count() > 1 ? groups.count() : 0;
  }

  private static FeatureResult of(
      String name, List<FittedFeature> fits, List<Groups> leftOut, List<Measurement> photos) {
    FittedFeature all = fits.get(0);
    double[] predicted = photos.stream().mapToDouble(all::response).toArray();
    List<Optional<CrossValidation>> validations = new ArrayList<>();
    int from = 1;
    for (Groups groups : leftOut) {
      int to = from + fits(groups);
      validations.add(
          to == from
              ? Optional.empty()
              : Optional.of(CrossValidation.of(groups, fits.subList(from, to), photos)));
      from = to;
    }
    return new FeatureResult(
        name,
        all,
        FitScores.of(Measurement.responses(photos), predicted),
        validations.get(0).orElseThrow(),
        validations.get(1),
        validations.get(2));
  }

  /** Fits that have not seen the objects that they are asked of; folds where there is but one. */
  public CrossValidation unseen() {
    return objects.orElse(validation);
  }
}
