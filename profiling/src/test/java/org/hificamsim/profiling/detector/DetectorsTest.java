package org.hificamsim.profiling.detector;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hificamsim.core.InputException;
import org.hificamsim.profiling.dataset.Patch;
import org.hificamsim.profiling.detector.RatioTest.Metric;
import org.hificamsim.profiling.opencv.Mats;
import org.hificamsim.profiling.opencv.OpenCv;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.opencv.core.Core;
import org.opencv.core.CvType;
import org.opencv.core.Mat;
import org.opencv.core.Scalar;
import org.opencv.core.Size;
import org.opencv.imgproc.Imgproc;

class DetectorsTest {
  @BeforeAll
  static void loadOpenCv() {
    OpenCv.load();
  }

  @ParameterizedTest
  @EnumSource
  void findsPictureOnlyInItself(FeatureDetector detector) {
    try (Mats mats = new Mats();
        Features template = detector.extractor().features(mats.own(blocks(1)));
        Features other = detector.extractor().features(mats.own(blocks(2)))) {
      assertTrue(template.count() > 50, detector + " finds " + template.count());
      assertEquals(template.count(), template.descriptors().rows());
      double self = confidence(RatioTest.THESIS, template, template);
      double cross = confidence(RatioTest.THESIS, template, other);
      assertTrue(self > 0.9, "self " + self);
      assertTrue(cross < 0.15, "other " + cross);
    }
  }

  @ParameterizedTest
  @EnumSource
  void plainPictureHasNoFeatures(FeatureDetector detector) {
    try (Mats mats = new Mats();
        Features nothing =
            detector
                .extractor()
                .features(mats.own(new Mat(200, 200, CvType.CV_8U, Scalar.all(90))));
        Features template = detector.extractor().features(mats.own(blocks(1)))) {
      assertEquals(0, nothing.count());
      assertEquals(0, confidence(RatioTest.THESIS, template, nothing));
      assertEquals(0, confidence(RatioTest.THESIS, nothing, template));
    }
  }

  @Test
  void strictRatioMatchesLess() {
    try (Mats mats = new Mats();
        Features template = FeatureDetector.ORB.extractor().features(mats.own(blocks(1)));
        Features other = FeatureDetector.ORB.extractor().features(mats.own(blocks(2)))) {
      int strict = new RatioTest(Metric.EUCLIDEAN, 0.6).matches(template, other).size();
      int loose = new RatioTest(Metric.EUCLIDEAN, 0.95).matches(template, other).size();
      assertTrue(strict < loose, strict + " and " + loose);
    }
  }

  @Test
  void metricsDifferOnlyForBinaryDescriptors() {
    assertEquals(Core.NORM_HAMMING, new RatioTest(Metric.HAMMING, 0.8).norm(true));
    assertEquals(Core.NORM_L2, new RatioTest(Metric.HAMMING, 0.8).norm(false));
    assertEquals(Core.NORM_L2, RatioTest.THESIS.norm(true));
    try (Mats mats = new Mats();
        Features template = FeatureDetector.ORB.extractor().features(mats.own(blocks(1)))) {
      assertTrue(confidence(new RatioTest(Metric.HAMMING, 0.8), template, template) > 0.9);
    }
  }

  @Test
  void rejectsUnknownDetectorAndListsKnownOnes() {
    assertTrue(
        assertThrows(InputException.class, () -> Detectors.column("brisk"))
            .getMessage()
            .contains("'brisk', expected some of orb, sift, surf"));
  }

  /** Returns a picture of random grey blocks. */
  private static Mat blocks(int seed) {
    Mat large = new Mat();
    try (Mats mats = new Mats()) {
      Mat small = mats.own(new Mat(24, 24, CvType.CV_8U));
      Core.setRNGSeed(seed);
      Core.randu(small, 0, 256);
      Imgproc.resize(small, large, new Size(360, 360), 0, 0, Imgproc.INTER_NEAREST);
    }
    return large;
  }

  /** Computes the confidence from all matches, wherever they are. */
  private static double confidence(RatioTest test, Features template, Features photo) {
    return MatchReading.ANYWHERE.confidence(
        template, photo, test.matches(template, photo), new Patch(0, 0, 1, 1));
  }
}
