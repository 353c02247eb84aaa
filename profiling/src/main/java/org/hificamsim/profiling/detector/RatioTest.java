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
 * @param metric the distance between descriptors
 * @param ratio the largest ratio of the two distances, (0, 1]; 0.8 in the thesis
 */
public record RatioTest(Metric metric, double ratio) {
  /** The test of the thesis: Euclidean, 0.8. */
  public static final RatioTest THESIS = new RatioTest(Metric.EUCLIDEAN, 0.8);

  /** A distance between two descriptors. */
  public enum Metric {
    /** The Euclidean distance, which thesis 5.3 uses for all detectors. */
    EUCLIDEAN,
    /** The number of differing bits, for ORB only; other detectors use the Euclidean distance. */
    HAMMING
  }

  /** Returns the matches that pass; empty if the image has fewer than two features. */
  public List<DMatch> matches(Features template, Features image) {
    if (template.count() == 0 || image.count() < 2) {
      return List.of();
    }
    boolean binary = template.descriptors().depth() == CvType.CV_8U;
    List<MatOfDMatch> pairs = new ArrayList<>();
    BFMatcher.create(norm(binary), false)
        .knnMatch(template.descriptors(), image.descriptors(), pairs, 2);
    List<DMatch> passing = new ArrayList<>();
    try (Mats mats = new Mats()) {
      for (MatOfDMatch pair : pairs) {
        DMatch[] nearest = mats.own(pair).toArray();
        if (nearest.length == 2 && nearest[0].distance < ratio * nearest[1].distance) {
          passing.add(nearest[0]);
        }
      }
    }
    return passing;
  }

  /** Returns OpenCV's norm; the number of differing bits is defined only for 8-bit descriptors. */
  int norm(boolean binary) {
    return binary && metric == Metric.HAMMING ? Core.NORM_HAMMING : Core.NORM_L2;
  }
}
