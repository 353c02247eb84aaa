package org.hificamsim.profiling.fit;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.InputException;
import org.hificamsim.core.parallel.Parallel;
import org.hificamsim.profiling.dataset.PhotoCamera;
import org.hificamsim.profiling.measure.Measurement;

/** Fits every f and then every g to a data set's measurements. */
public final class Fitting {
  private final FitSettings settings;

  public Fitting(FitSettings settings) {
    this.settings = settings;
  }

  /**
   * Fits everything; the same on any number of threads.
   *
   * @throws InputException when the measurements do not determine a fit
   */
  public FitResult fit(PhotoCamera camera, List<Measurement> photos, int threads) {
    int k = settings.folds();
    if (photos.size() < 2 * k) {
      throw InputException.of(
          "%s rows, expected at least %s for %s folds", photos.size(), 2 * k, k);
    }
    Groups folds = Groups.folds(photos.size(), k, settings.seed());
    Groups objects = Groups.byObject(photos);
    FitResult features =
        new FitResult(
            camera,
            photos,
            List.copyOf(photos.get(0).confidences().keySet()),
            FeatureResult.all(FeatureRegression.all(camera, settings), photos, folds, threads),
            objects.count() > 1 ? objects : folds,
            settings.thresholds(),
            Map.of());
    return features.with(models(features, objects, threads));
  }

  /** One g that has to be fitted. */
  private record Job(String detector, String on, double[] x, List<double[]> unseenX) {}

  private Map<String, Map<String, DetectorFit>> models(
      FitResult result, Groups objects, int threads) {
    List<Job> jobs =
        result.detectors().stream().flatMap(detector -> jobs(result, detector).stream()).toList();
    List<DetectorFit> fits =
        Parallel.map(
            jobs,
            threads,
            job ->
                DetectorFit.of(
                    settings,
                    objects,
                    result.unseen(),
                    job.x(),
                    job.unseenX(),
                    result.confidences(job.detector())));
    Map<String, Map<String, DetectorFit>> models = new LinkedHashMap<>();
    for (int i = 0; i < jobs.size(); i++) {
      models
          .computeIfAbsent(jobs.get(i).detector(), any -> new LinkedHashMap<>())
          .put(jobs.get(i).on(), fits.get(i));
    }
    return models;
  }

  /** On measured PIP, and on what each f says. */
  private static List<Job> jobs(FitResult result, String detector) {
    List<Job> jobs = new ArrayList<>();
    double[] measured = result.measuredPip();
    jobs.add(
        new Job(
            detector,
            FitResult.GROUND_TRUTH,
            measured,
            Collections.nCopies(result.unseen().count(), measured)));
    for (FeatureResult f : result.features()) {
      List<double[]> unseen = f.unseen().fits().stream().map(result::predictedPip).toList();
      jobs.add(new Job(detector, f.name(), result.predictedPip(f.name()), unseen));
    }
    return jobs;
  }
}
