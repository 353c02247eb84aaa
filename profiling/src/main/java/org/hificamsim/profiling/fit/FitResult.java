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
 * @param detectors by name, in the order of the measurements' columns
 * @param features every f, in the order of the report
 * @param unseen what was left out together to see how g does on what it has not seen: objects, or
 *     folds where there is one object
 * @param thresholds by detector, from which confidence on it detects, where that is known
 * @param models every g: by detector, then by the name of what it was fitted on, an f or {@link
 *     #GROUND_TRUTH}
 */
public record FitResult(
    PhotoCamera camera,
    List<Measurement> measurements,
    List<String> detectors,
    List<FeatureResult> features,
    Groups unseen,
    Map<String, Double> thresholds,
    Map<String, Map<String, DetectorFit>> models) {
  /** On measured PIP. */
  public static final String GROUND_TRUTH = "ground-truth";

  /** On CamSim's standard confidence. */
  public static final String CAMSIM = "camsim-standard";

  private static final double SLOPE = 0.95;
  private static final double LOSS = 0.15;

  /** The same with every g. */
  FitResult with(Map<String, Map<String, DetectorFit>> everyModel) {
    return new FitResult(camera, measurements, detectors, features, unseen, thresholds, everyModel);
  }

  /** One f. */
  public FeatureResult feature(String name) {
    return features.stream().filter(f -> f.name().equals(name)).findFirst().orElseThrow();
  }

  /** One g. */
  public DetectorFit model(String detector, String on) {
    return models.get(detector).get(on);
  }

  /** The thesis's g, a line: on an f, on {@link #GROUND_TRUTH} or on {@link #CAMSIM}. */
  public LineFit line(String detector, String on) {
    return LineFit.of(predictor(on), confidences(detector));
  }

  /** What a g is fitted on: the PIP of an f, {@link #GROUND_TRUTH} or {@link #CAMSIM}. */
  public double[] predictor(String on) {
    return switch (on) {
      case GROUND_TRUTH -> measuredPip();
      case CAMSIM -> camSimConfidence();
      default -> predictedPip(on);
    };
  }

  /**
   * CamSim's standard confidence {@code 0.95 (1 - r / rMax) - 0.15} (Eq 6.2) for the laboratory's
   * zooms. CamSim's zoom is a radius, which falls as the focal length grows; as thesis 6.2 says,
   * its values are computed with the focal lengths as radii and dealt out in reverse order.
   */
  private double[] camSimConfidence() {
    List<Double> zooms =
        measurements.stream().map(Measurement::focalLength).distinct().sorted().toList();
    int last = zooms.size() - 1;
    return measurements.stream()
        .mapToDouble(m -> zooms.get(last - zooms.indexOf(m.focalLength())) / zooms.get(last))
        .map(share -> SLOPE * (1 - share) - LOSS)
        .toArray();
  }

  /** The photos of each object, by its name. */
  public Map<String, List<Measurement>> byObject() {
    return measurements.stream()
        .collect(groupingBy(Measurement::object, LinkedHashMap::new, toList()));
  }

  /** One detector's confidences. */
  public double[] confidences(String detector) {
    return measurements.stream().mapToDouble(m -> m.confidence(detector)).toArray();
  }

  /** The PIP that an f predicts for each measurement. */
  public double[] predictedPip(String f) {
    return predictedPip(feature(f).fit());
  }

  /** The same of one fit of an f. */
  double[] predictedPip(FittedFeature fit) {
    return measurements.stream().mapToDouble(fit::pip).toArray();
  }

  /** The ground-truth PIP of each measurement. */
  public double[] measuredPip() {
    return measurements.stream().mapToDouble(Measurement::pip).toArray();
  }
}
