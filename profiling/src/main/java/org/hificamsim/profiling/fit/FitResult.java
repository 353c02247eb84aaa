package org.hificamsim.profiling.fit;

import static java.util.stream.Collectors.groupingBy;
import static java.util.stream.Collectors.toList;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.hificamsim.profiling.dataset.PhotoCamera;
import org.hificamsim.profiling.measure.Measurement;

/**
 * Everything that was fitted to a data set.
 *
 * @param detectors the names of the detectors, in the order of the measurements' columns
 * @param features every f, in the order of the report
 * @param unseen the groups of the cross-validation of g: objects, or folds if there is one object
 * @param thresholds the known thresholds by detector, the least confidence of a detection
 * @param models every g, by detector and predictor (an f or {@link #GROUND_TRUTH})
 */
public record FitResult(
    PhotoCamera camera,
    List<Measurement> measurements,
    List<String> detectors,
    List<FeatureResult> features,
    Groups unseen,
    Map<String, Double> thresholds,
    Map<String, Map<String, DetectorFit>> models) {
  /** The predictor measured PIP. */
  public static final String GROUND_TRUTH = "ground-truth";

  /** The predictor CamSim's standard confidence. */
  public static final String CAMSIM = "camsim-standard";

  private static final double SLOPE = 0.95;
  private static final double LOSS = 0.15;

  /** Returns a copy with every g. */
  FitResult with(Map<String, Map<String, DetectorFit>> everyModel) {
    return new FitResult(camera, measurements, detectors, features, unseen, thresholds, everyModel);
  }

  /** Returns the f of a name. */
  public FeatureResult feature(String name) {
    return features.stream()
        .filter(feature -> feature.name().equals(name))
        .findFirst()
        .orElseThrow();
  }

  /** Returns the g of a detector on a predictor. */
  public DetectorFit model(String detector, String predictor) {
    return models.get(detector).get(predictor);
  }

  /** Returns the g of the thesis, a line, on an f, {@link #GROUND_TRUTH} or {@link #CAMSIM}. */
  public LineFit line(String detector, String predictor) {
    return LineFit.of(predictor(predictor), confidences(detector));
  }

  /**
   * Returns the values that a g is fitted on: PIP of an f, {@link #GROUND_TRUTH} or {@link
   * #CAMSIM}.
   */
  public double[] predictor(String predictor) {
    return switch (predictor) {
      case GROUND_TRUTH -> measuredPip();
      case CAMSIM -> camSimConfidence();
      default -> predictedPip(predictor);
    };
  }

  /**
   * CamSim's standard confidence {@code 0.95 (1 - r / rMax) - 0.15} (Eq 6.2) for the zooms of the
   * laboratory. CamSim's zoom is a radius, which falls as the focal length grows; as thesis 6.2
   * says, its values are computed with the focal lengths as radii and assigned in reverse order.
   */
  private double[] camSimConfidence() {
    List<Double> zooms =
        measurements.stream().map(Measurement::focalLength).distinct().sorted().toList();
    int last = zooms.size() - 1;
    return measurements.stream()
        .mapToDouble(
            photo -> zooms.get(last - zooms.indexOf(photo.focalLength())) / zooms.get(last))
        .map(share -> SLOPE * (1 - share) - LOSS)
        .toArray();
  }

  /** Returns the photos of each object, by its name. */
  public Map<String, List<Measurement>> byObject() {
    return measurements.stream()
        .collect(groupingBy(Measurement::object, LinkedHashMap::new, toList()));
  }

  /** Returns the confidences of a detector. */
  public double[] confidences(String detector) {
    return measurements.stream().mapToDouble(photo -> photo.confidence(detector)).toArray();
  }

  /** Returns the PIP that an f predicts for each measurement. */
  public double[] predictedPip(String f) {
    return predictedPip(feature(f).fit());
  }

  /** Returns the PIP that a fit of an f predicts for each measurement. */
  double[] predictedPip(FittedFeature fit) {
    return measurements.stream().mapToDouble(fit::pip).toArray();
  }

  /** Returns the true PIP of each measurement. */
  public double[] measuredPip() {
    return measurements.stream().mapToDouble(Measurement::pip).toArray();
  }
}
