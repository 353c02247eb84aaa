package org.hificamsim.profiling.report;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import org.hificamsim.hifi.detector.DetectorLine;
import org.hificamsim.profiling.fit.CamSimConfidence;
import org.hificamsim.profiling.fit.DetectorShape;
import org.hificamsim.profiling.fit.FitResult;
import org.hificamsim.profiling.fit.FitScores;
import org.hificamsim.profiling.fit.ShapeFit;

/**
 * The fidelity ladder: from "certain in view" to support vectors, how well each model tells the
 * confidence of objects that it has not seen and how long one evaluation takes.
 */
public final class FidelityLadder {
  /** The models, the plainest first. */
  static final List<String> MODELS =
      List.of("geometric", FitResult.CAMSIM, "pinhole", "power", "lin", "svr-lin", "sr", "svr-rbf");

  /** The mean of the confidences, whatever the PIP. */
  private static final DetectorShape MEAN =
      new DetectorShape(
          "mean", (pip, y) -> new DetectorLine(0, Arrays.stream(y).average().orElseThrow()));

  private FidelityLadder() {}

  /**
   * One step.
   *
   * @param unseen how well it tells the confidence of what it has not seen; {@code geometric}'s
   *     value never varies, so that it tells the mean of what it has
   * @param accuracy how often it puts that on the right side of the threshold (balanced)
   * @param nanoseconds per evaluation of the shipped model of this kind; NaN where nobody measured
   */
  public record Step(String model, FitScores unseen, double accuracy, double nanoseconds) {}

  /** The ladder of one detector. */
  public static List<Step> of(FitResult result, String detector, Map<String, Double> nanoseconds) {
    return MODELS.stream().map(model -> step(result, detector, model, nanoseconds)).toList();
  }

  private static Step step(
      FitResult result, String detector, String model, Map<String, Double> nanoseconds) {
    ShapeFit fit =
        switch (model) {
          case "geometric" -> onValues(result, detector, MEAN, result.measuredPip());
          case FitResult.CAMSIM ->
              onValues(
                  result,
                  detector,
                  DetectorShape.of("line"),
                  CamSimConfidence.of(result.measurements()));
          default -> result.model(detector, model).chosen();
        };
    return new Step(
        model,
        fit.unseen(),
        DetectionAccuracy.of(result, detector)
            .accuracy(result.confidences(detector), fit.predicted()),
        nanoseconds.getOrDefault(model, Double.NaN));
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
