package org.hificamsim.profiling.report;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import org.hificamsim.hifi.detector.DetectorLine;
import org.hificamsim.profiling.fit.DetectorFit;
import org.hificamsim.profiling.fit.DetectorShape;
import org.hificamsim.profiling.fit.FeatureResult;
import org.hificamsim.profiling.fit.FitResult;
import org.hificamsim.profiling.fit.ShapeFit;

/**
 * The fidelity ladder: from "certain in view" to support vectors, how well each model predicts the
 * confidence of objects that it has not seen and how long one evaluation takes.
 */
final class FidelityLadder {
  /** The mean of the confidences, whatever the PIP. */
  private static final DetectorShape MEAN =
      new DetectorShape(
          "mean", (pip, y) -> new DetectorLine(0, Arrays.stream(y).average().orElseThrow()));

  private FidelityLadder() {}

  /**
   * One step.
   *
   * @param fit its g; {@code geometric}'s value never varies, so that it predicts the mean of what
   *     it has seen
   * @param accuracy how often it puts what it has not seen on the right side of the threshold
   *     (balanced)
   * @param nanoseconds per evaluation of the shipped model of this kind; NaN where nobody measured
   */
  record Step(
      String detector,
      String model,
      ShapeFit fit,
      boolean refused,
      double accuracy,
      double nanoseconds) {}

  /** The ladder of one detector: the plainest model first, then every f. */
  static List<Step> of(FitResult result, String detector) {
    ShapeFit mean = onValues(result, detector, MEAN, result.measuredPip());
    ShapeFit camSim =
        onValues(result, detector, DetectorShape.of("line"), result.predictor(FitResult.CAMSIM));
    List<Step> steps = new ArrayList<>();
    steps.add(step(result, detector, "geometric", mean, false));
    steps.add(step(result, detector, FitResult.CAMSIM, camSim, false));
    for (FeatureResult f : result.features()) {
      DetectorFit g = result.model(detector, f.name());
      steps.add(step(result, detector, f.name(), g.chosen(), g.refused()));
    }
    return steps;
  }

  private static Step step(
      FitResult result, String detector, String model, ShapeFit fit, boolean refused) {
    return new Step(
        detector,
        model,
        fit,
        refused,
        DetectionAccuracy.of(result, detector)
            .accuracy(result.confidences(detector), fit.predicted()),
        PublishedTables.nanoseconds().getOrDefault(model, Double.NaN));
  }

  private static ShapeFit onValues(
      FitResult result, String detector, DetectorShape shape, double[] values) {
    return ShapeFit.of(
        shape,
        values,
        Collections.nCopies(result.unseen().count(), values),
        result.confidences(detector),
        result.unseen());
  }
}
