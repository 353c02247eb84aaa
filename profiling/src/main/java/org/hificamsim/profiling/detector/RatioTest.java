package org.hificamsim.profiling.detector;

import java.util.ArrayList;
import java.util.List;
import org.hificamsim.profiling.opencv.Mats;
import org.opencv.core.Core;
import org.opencv.core.CvType;
import org.opencv.core.DMatch;
import org.opencv.core.MatOfDMatch;
import org.opencv.features2d.BFMatcher;

/**
 * Brute-force matching with Lowe's ratio test (thesis 5.3): a template feature is found when its
 * nearest neighbour in the image is closer than {@code ratio} times the second nearest.
 *
 * @param metric between descriptors
 * @param ratio (0, 1]; 0.8 in the thesis
 */
public record RatioTest(Metric metric, double ratio) {
  /** The thesis's: Euclidean, 0.8. */
  public static final RatioTest THESIS = new RatioTest(Metric.EUCLIDEAN, 0.8);

  /** How far apart two descriptors are. */
  public enum Metric {
    /** The root of the summed squares, as the thesis has it for all detectors (thesis 5.3). */
    EUCLIDEAN,
    /** The number of bits that differ; for ORB, the others keep the Euclidean distance. */
    HAMMING
  }

  /** The matches that pass; none where the image has fewer than two features. */
  public List<DMatch> matches(Features template, Features image) {
    if (template.count() == 0 || image.count() < 2) {
      return List.of();
    }
    boolean bits = template.descriptors().depth() == CvType.CV_8U;
    List<MatOfDMatch> pairs = new ArrayList<>();
    BFMatcher.create(norm(bits), false)
        .knnMatch(template.descriptors(), image.descriptors(), pairs, 2);
    List<DMatch> good = new ArrayList<>();
    try (Mats mats = new Mats()) {
      for (MatOfDMatch pair : pairs) {
        DMatch[] nearest = mats.own(pair).toArray();
        if (nearest.length == 2 && nearest[0].distance < ratio * nearest[1].distance) {
          good.add(nearest[0]);
        }
      }
    }
    return good;
  }

  /** OpenCV's norm for descriptors of this depth: bits exist in 8-bit ones alone. */
  int norm(boolean bits) {
    return bits && metric == Metric.HAMMING ? Core.NORM_HAMMING : Core.NORM_L2;
  }
}
