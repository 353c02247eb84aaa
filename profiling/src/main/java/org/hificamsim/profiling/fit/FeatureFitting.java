package org.hificamsim.profiling.fit;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.hificamsim.core.parallel.Parallel;

/** Fits every f to all rows, and to all but those of each fold, object and lens. */
final class FeatureFitting {
  private final List<Observation> observations;
  private final Groups folds;
  private final Groups objects;
  private final Groups lenses;

  FeatureFitting(List<Observation> observations, Groups folds, Groups objects, Groups lenses) {
    this.observations = observations;
    this.folds = folds;
    this.objects = objects;
    this.lenses = lenses;
  }

  /** One fit that has to be made: to these rows. */
  private record Job(FeatureRegression regression, List<Observation> rows) {
    FittedFeature fit() {
      return regression.fit(rows);
    }
  }

  List<FeatureResult> all(List<FeatureRegression> regressions, int threads) {
    List<Job> jobs = new ArrayList<>();
    regressions.forEach(regression -> jobs.addAll(jobs(regression)));
    Iterator<FittedFeature> fits = Parallel.map(jobs, threads, Job::fit).iterator();
    return regressions.stream().map(regression -> result(regression.name(), fits)).toList();
  }

  private List<Job> jobs(FeatureRegression regression) {
    List<Job> jobs = new ArrayList<>();
    jobs.add(new Job(regression, observations));
    for (Groups groups : List.of(folds, objects, lenses)) {
      for (int group = 0; group < fits(groups); group++) {
        jobs.add(new Job(regression, Groups.at(groups.others(group), observations)));
      }
    }
    return jobs;
  }

  /** How many fits groups need: none where leaving one out leaves nothing. */
  private static int fits(Groups groups) {
    return groups.count() > 1 ? groups.count() : 0;
  }

  private FeatureResult result(String name, Iterator<FittedFeature> fits) {
    FittedFeature fit = fits.next();
    double[] observed = observations.stream().mapToDouble(Observation::response).toArray();
    double[] predicted = observations.stream().mapToDouble(fit::response).toArray();
    return new FeatureResult(
        name,
        fit,
        Scores.of(observed, predicted),
        validation(folds, fits).orElseThrow(),
        validation(objects, fits),
        validation(lenses, fits));
  }

  private Optional<CrossValidation> validation(Groups groups, Iterator<FittedFeature> fits) {
    List<FittedFeature> own = Stream.generate(fits::next).limit(fits(groups)).toList();
    return own.isEmpty()
        ? Optional.empty()
        : Optional.of(CrossValidation.of(groups, own, observations));
  }
}
