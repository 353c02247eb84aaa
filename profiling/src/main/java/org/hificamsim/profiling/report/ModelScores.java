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
 * How well a model of a detector predicts the confidence of objects that it has not seen.
 *
 * @param fit its g; {@code geometric}'s value never varies, so that it predicts the mean of what it
 *     has seen
 * @param accuracy how often it puts what it has not seen on the right side of the threshold
 *     (balanced)
 */
record ModelScores(String detector, String model, ShapeFit fit, boolean refused, double accuracy) {
  /** The mean of the confidences, whatever the PIP. */
  private static final DetectorShape MEAN =
      new DetectorShape(
          "mean", (pip, y) -> new DetectorLine(0, Arrays.stream(y).average().orElseThrow()));

  /**
   * The models of one detector: what CamSim has first, the plainest before others, then every f.
   */
  static List<ModelScores> of(FitResult result, String detector) {
    ShapeFit mean = onValues(result, detector, MEAN, result.measuredPip());
    ShapeFit camSim =
        onValues(result, detector, DetectorShape.of("line"), result.predictor(FitResult.CAMSIM));
    List<ModelScores> all = new ArrayList<>();
    all.add(of(result, detector, "geometric", mean, false));
    all.add(of(result, detector, FitResult.CAMSIM, camSim, false));
    for (FeatureResult f : result.features()) {
      DetectorFit g = result.model(detector, f.name());
      all.add(of(result, detector, f.name(), g.chosen(), g.refused()));
    }
    return all;
  }

  private static ModelScores of(
      FitResult result, String detector, String model, ShapeFit fit, boolean refused) {
    double accuracy =
        DetectionAccuracy.of(result, detector)
            .accuracy(result.confidences(detector), fit.predicted());
    return new ModelScores(detector, model, fit, refused, accuracy);
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
