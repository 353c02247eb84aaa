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
   * Fits everything. The result does not depend on the number of threads.
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

  /** Fits every g on measured PIP and on the predictions of each f. */
  private Map<String, Map<String, DetectorFit>> models(
      FitResult result, Groups objects, int threads) {
    List<String> names = new ArrayList<>(List.of(FitResult.GROUND_TRUTH));
    result.features().forEach(f -> names.add(f.name()));
    Map<String, Map<String, DetectorFit>> models = new LinkedHashMap<>();
    for (String detector : result.detectors()) {
      List<DetectorFit> fits =
          Parallel.map(names, threads, predictor -> model(result, objects, detector, predictor));
      Map<String, DetectorFit> byName = new LinkedHashMap<>();
      for (int i = 0; i < fits.size(); i++) {
        byName.put(names.get(i), fits.get(i));
      }
      models.put(detector, byName);
    }
    return models;
  }

  private DetectorFit model(FitResult result, Groups objects, String detector, String predictor) {
    double[] x = result.predictor(predictor);
    List<double[]> unseenX =
        predictor.equals(FitResult.GROUND_TRUTH)
            ? Collections.nCopies(result.unseen().count(), x)
            : result.feature(predictor).unseen().fits().stream().map(result::predictedPip).toList();
    return DetectorFit.of(
        settings, objects, result.unseen(), x, unseenX, result.confidences(detector));
  }
}
