package org.hificamsim.profiling.fit;

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
 * @param lines the thesis's g: by detector, then by the name of what it was fitted on, an f, {@link
 *     #GROUND_TRUTH} or {@link #CAMSIM}
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
    Map<String, Map<String, LineFit>> lines,
    Map<String, Map<String, DetectorFit>> models) {
  /** On measured PIP. */
  public static final String GROUND_TRUTH = "ground-truth";

  /** On CamSim's standard confidence. */
  public static final String CAMSIM = "camsim-standard";

  /** The same with every g. */
  FitResult with(
      Map<String, Map<String, LineFit>> everyLine,
      Map<String, Map<String, DetectorFit>> everyModel) {
    return new FitResult(
        camera, measurements, detectors, features, unseen, thresholds, everyLine, everyModel);
  }

  /** One f. */
  public FeatureResult feature(String name) {
    return features.stream().filter(f -> f.name().equals(name)).findFirst().orElseThrow();
  }

  /** One g. */
  public DetectorFit model(String detector, String on) {
    return models.get(detector).get(on);
  }

  /** One of the thesis's lines. */
  public LineFit line(String detector, String on) {
    return lines.get(detector).get(on);
  }

  /** The measurements as rows of a regression. */
  public List<Observation> observations() {
    return observations(measurements);
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
    return observations().stream().mapToDouble(fit::pip).toArray();
  }

  /** The ground-truth PIP of each measurement. */
  public double[] measuredPip() {
    return measurements.stream().mapToDouble(Measurement::pip).toArray();
  }

  static List<Observation> observations(List<Measurement> measurements) {
    return measurements.stream()
        .map(m -> new Observation(m.size(), m.distance(), m.focalLength(), m.pip()))
        .toList();
  }
}
