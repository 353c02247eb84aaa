package org.hificamsim.profiling.fit;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.hificamsim.profiling.Parallel;
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
    List<Observation> observations = FitResult.observations(measurements);
    List<FeatureResult> features =
        Parallel.map(regressions(camera), threads, regression -> result(regression, observations));
    List<String> detectors = List.copyOf(measurements.get(0).confidences().keySet());
    FitResult result = new FitResult(camera, measurements, detectors, features, Map.of());
    Map<String, Map<String, LineFit>> lines = new LinkedHashMap<>();
    detectors.forEach(detector -> lines.put(detector, lines(result, detector)));
    return new FitResult(camera, measurements, detectors, features, lines);
  }

  /** Every way to fit f. */
  private List<FeatureRegression> regressions(PhotoCamera camera) {
    return List.of(
        new LinearRegression(),
        new LinearSupportVectors(settings.vectors()),
        new RbfSupportVectors(settings.vectors()),
        new SymbolicRegression(settings.symbolic()),
        new PowerRegression(),
        new PinholeLaw(camera.sensorWidth(), camera.sensorHeight()));
  }

  private FeatureResult result(FeatureRegression regression, List<Observation> observations) {
    FittedFeature fit = regression.fit(observations);
    double[] observed = observations.stream().mapToDouble(Observation::response).toArray();
    double[] predicted = observations.stream().mapToDouble(fit::response).toArray();
    return new FeatureResult(
        regression.name(),
        fit,
        Scores.of(observed, predicted),
        CrossValidation.of(regression, observations, settings.folds(), settings.seed()));
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
}
