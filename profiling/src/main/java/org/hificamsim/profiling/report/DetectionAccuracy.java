package org.hificamsim.profiling.report;

import org.hificamsim.core.detection.DetectionRule.Chance;
import org.hificamsim.core.detection.Scatter;
import org.hificamsim.profiling.fit.DetectorFit;
import org.hificamsim.profiling.fit.FitResult;

/**
 * Detect or not detect: whether a model puts a photo on the side of a threshold on which the
 * measured confidence lies.
 *
 * @param threshold confidence from which a photo counts as detected
 */
record DetectionAccuracy(double threshold) {
  /**
   * By the detector's own threshold, else by the one that {@code --detect chance} would take: g at
   * 0, and the scatter about g.
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
