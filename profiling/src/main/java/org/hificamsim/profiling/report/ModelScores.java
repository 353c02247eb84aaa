package org.hificamsim.profiling.report;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import org.hificamsim.core.detection.DetectionRule.Chance;
import org.hificamsim.core.detection.Scatter;
import org.hificamsim.hifi.detector.DetectorLine;
import org.hificamsim.profiling.fit.DetectorFit;
import org.hificamsim.profiling.fit.DetectorShape;
import org.hificamsim.profiling.fit.FeatureResult;
import org.hificamsim.profiling.fit.FitResult;
import org.hificamsim.profiling.fit.ShapeFit;

/**
 * The quality of a model's predictions of a detector's confidence for unseen objects.
 *
 * @param fit the fit of g; for {@code geometric} it always predicts the mean of the seen
 *     confidences
 * @param accuracy the balanced accuracy of detect or not detect on unseen photos
 */
record ModelScores(String detector, String model, ShapeFit fit, boolean rejected, double accuracy) {
  /** A shape that is the mean of the confidences at any PIP. */
  private static final DetectorShape MEAN =
      new DetectorShape(
          "mean", (pip, y) -> new DetectorLine(0, Arrays.stream(y).average().orElseThrow()));

  /** Returns the scores of a detector's models: CamSim's, the simplest first, then every f. */
  static List<ModelScores> of(FitResult result, String detector) {
    ShapeFit mean = onValues(result, detector, MEAN, result.measuredPip());
    ShapeFit camSim =
        onValues(result, detector, DetectorShape.of("line"), result.predictor(FitResult.CAMSIM));
    List<ModelScores> all = new ArrayList<>();
    all.add(of(result, detector, "geometric", mean, false));
    all.add(of(result, detector, FitResult.CAMSIM, camSim, false));
    for (FeatureResult f : result.features()) {
      DetectorFit g = result.model(detector, f.name());
      all.add(of(result, detector, f.name(), g.chosen(), g.rejected()));
    }
    return all;
  }

  private static ModelScores of(
      FitResult result, String detector, String model, ShapeFit fit, boolean rejected) {
    double accuracy =
        DetectionAccuracy.of(result, detector)
            .accuracy(result.confidences(detector), fit.predicted());
    return new ModelScores(detector, model, fit, rejected, accuracy);
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

  /**
   * The accuracy of detect or not detect: whether the predicted and the measured confidence lie on
   * the same side of a threshold.
   *
   * @param threshold the least confidence that counts as detected
   */
  record DetectionAccuracy(double threshold) {
    /**
     * Uses the detector's own threshold, or that of the detection rule chance: g at 0 and the
     * scatter about g.
     */
    static DetectionAccuracy of(FitResult result, String detector) {
      Double own = result.thresholds().get(detector);
      return own == null ? byChance(result, detector) : new DetectionAccuracy(own);
    }

    private static DetectionAccuracy byChance(FitResult result, String detector) {
      DetectorFit fit = result.model(detector, FitResult.GROUND_TRUTH);
      Scatter scatter = fit.chosenScatter().residuals().about(fit.chosen().g());
      return new DetectionAccuracy(scatter.threshold(Chance.DEFAULT_ALPHA));
    }

    /** Returns the share of the photos that are detected. */
    double detected(double[] measured) {
      return countOnSide(measured, measured, true) / (double) measured.length;
    }

    /**
     * Returns the balanced accuracy: the mean of the shares of detected and of undetected photos
     * that are predicted correctly, one half for a guess; NaN if all photos are of one kind.
     */
    double accuracy(double[] measured, double[] predicted) {
      int detected = countOnSide(measured, measured, true);
      int undetected = measured.length - detected;
      double hits = countOnSide(measured, predicted, true) / (double) detected;
      double rejections = countOnSide(measured, predicted, false) / (double) undetected;
      return (hits + rejections) / 2;
    }

    /** Returns the number of photos on this side of the threshold in both. */
    private int countOnSide(double[] measured, double[] predicted, boolean side) {
      int count = 0;
      for (int i = 0; i < measured.length; i++) {
        count += measured[i] >= threshold == side && predicted[i] >= threshold == side ? 1 : 0;
      }
      return count;
    }
  }
}
