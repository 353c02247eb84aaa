package org.hificamsim.profiling.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.parallel.Parallel;
import org.hificamsim.profiling.dataset.PhotoCamera;
import org.hificamsim.profiling.measure.Measurement;

/** Fits every f and every g to a data set's measurements. */
public final class Fitting {
  private final FitSettings settings;

  public Fitting(FitSettings settings) {
    this.settings = settings;
  }

  /**
   * Fits everything; the same on any number of threads.
   *
   * @throws org.hificamsim.core.InputException when the measurements do not determine a fit
   */
  public FitResult fit(PhotoCamera camera, List<Measurement> measurements, int threads) {
    Groups objects = Groups.byObject(measurements);
    Groups folds = CrossValidation.folds(measurements.size(), settings.folds(), settings.seed());
    Groups unseen = objects.count() > 1 ? objects : folds;
    List<Observation> observations = FitResult.observations(measurements);
    List<FeatureResult> features =
        new FeatureFitting(observations, folds, objects, Groups.byLens(measurements))
            .all(regressions(camera), threads);
    List<String> detectors = List.copyOf(measurements.get(0).confidences().keySet());
    FitResult plain =
        new FitResult(
            camera,
            measurements,
            detectors,
            features,
            unseen,
            settings.thresholds(),
            Map.of(),
            Map.of());
    Map<String, Map<String, LineFit>> lines = new LinkedHashMap<>();
    detectors.forEach(detector -> lines.put(detector, lines(plain, detector)));
    DetectorFitting fitting =
        new DetectorFitting(objects, unseen, settings.shape(), settings.seed());
    return plain.with(lines, models(plain, fitting, threads));
  }

  /** Every way to fit f, the simplest first. */
  private List<FeatureRegression> regressions(PhotoCamera camera) {
    return List.of(
        new PinholeLaw(camera.sensorWidth(), camera.sensorHeight()),
        new PowerRegression(),
        new LinearRegression(),
        new LinearSupportVectors(settings.vectors()),
        new SymbolicRegression(settings.symbolic()),
        new RbfSupportVectors(settings.vectors()));
  }

  private static Map<String, LineFit> lines(FitResult result, String detector) {
    double[] y = result.confidences(detector);
    Map<String, LineFit> lines = new LinkedHashMap<>();
    lines.put(FitResult.GROUND_TRUTH, LineFit.of(result.measuredPip(), y));
    for (FeatureResult f : result.features()) {
      lines.put(f.name(), LineFit.of(result.predictedPip(f.name()), y));
    }
    lines.put(FitResult.CAMSIM, LineFit.of(CamSimConfidence.of(result.measurements()), y));
    return lines;
  }

  /** One g that has to be fitted. */
  private record Job(String detector, String on, double[] x, double[][] unseenX) {}

  private Map<String, Map<String, DetectorFit>> models(
      FitResult result, DetectorFitting fitting, int threads) {
    List<Job> jobs = new ArrayList<>();
    result.detectors().forEach(detector -> jobs.addAll(jobs(result, detector)));
    List<DetectorFit> fits =
        Parallel.map(
            jobs,
            threads,
            job -> fitting.fit(job.x(), job.unseenX(), result.confidences(job.detector())));
    Map<String, Map<String, DetectorFit>> models = new LinkedHashMap<>();
    for (int i = 0; i < jobs.size(); i++) {
      models
          .computeIfAbsent(jobs.get(i).detector(), any -> new LinkedHashMap<>())
          .put(jobs.get(i).on(), fits.get(i));
    }
    return models;
  }

  private static List<Job> jobs(FitResult result, String detector) {
    List<Job> jobs = new ArrayList<>();
    double[] measured = result.measuredPip();
    double[][] unseen = new double[result.unseen().count()][];
    Arrays.fill(unseen, measured);
    jobs.add(new Job(detector, FitResult.GROUND_TRUTH, measured, unseen));
    for (FeatureResult f : result.features()) {
      double[][] unseenF =
          f.unseen().fits().stream().map(result::predictedPip).toArray(double[][]::new);
      jobs.add(new Job(detector, f.name(), result.predictedPip(f.name()), unseenF));
    }
    return jobs;
  }
}
