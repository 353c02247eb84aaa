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

  /**
   * Detect or not detect: whether a model puts a photo on the side of a threshold on which the
   * measured confidence lies.
   *
   * @param threshold confidence from which a photo counts as detected
   */
  record DetectionAccuracy(double threshold) {
    /**
     * By the detector's own threshold, else by the one that {@code --detect chance} would take: g
     * at 0, and the scatter about g.
     */
    static DetectionAccuracy of(FitResult result, String detector) {
      Double own = result.thresholds().get(detector);
      return own == null ? byChance(result, detector) : new DetectionAccuracy(own);
    }

    private static DetectionAccuracy byChance(FitResult result, String detector) {
      DetectorFit fit = result.model(detector, FitResult.GROUND_TRUTH);
      Scatter scatter = fit.drawnFrom().residuals().about(fit.chosen().g());
      return new DetectionAccuracy(scatter.threshold(Chance.DEFAULT_ALPHA));
    }

    /** The share of the photos that are detected. */
    double detected(double[] measured) {
      return share(measured, measured, true) / (double) measured.length;
    }

    /**
     * Balanced accuracy: the mean of the shares of the detected and of the undetected that are
     * predicted rightly, one half for a guess; NaN where all photos are of one kind.
     */
    double accuracy(double[] measured, double[] predicted) {
      int detected = share(measured, measured, true);
      int undetected = measured.length - detected;
      double hits = share(measured, predicted, true) / (double) detected;
      double rejections = share(measured, predicted, false) / (double) undetected;
      return (hits + rejections) / 2;
    }

    /** How many are on this side in both. */
    private int share(double[] measured, double[] predicted, boolean side) {
      int count = 0;
      for (int i = 0; i < measured.length; i++) {
        count += measured[i] >= threshold == side && predicted[i] >= threshold == side ? 1 : 0;
      }
      return count;
    }
  }
}
