package org.hificamsim.profiling.detector;

import org.hificamsim.profiling.opencv.Mats;
import org.opencv.core.Mat;
import org.opencv.core.MatOfKeyPoint;
import org.opencv.features2d.Feature2D;
import org.opencv.features2d.ORB;
import org.opencv.features2d.SIFT;

/**
 * A detector of OpenCV's with OpenCV's defaults: ORB (500 features, thesis 5.4) or SIFT (thesis
 * 5.5).
 */
public final class OpenCvDetector implements FeatureDetector {
  private final String name;
  private final Feature2D detector;

  private OpenCvDetector(String name, Feature2D detector) {
    this.name = name;
    this.detector = detector;
  }

  /** Oriented FAST and rotated BRIEF. */
  public static FeatureDetector orb() {
    return new OpenCvDetector("orb", ORB.create());
  }

  /** The scale-invariant feature transform. */
  public static FeatureDetector sift() {
    return new OpenCvDetector("sift", SIFT.create());
  }

  @Override
  public String name() {
    return name;
  }

  @Override
  public Features detect(Mat grey) {
    try (Mats mats = new Mats()) {
      MatOfKeyPoint points = mats.own(new MatOfKeyPoint());
      Mat descriptors = new Mat();
      detector.detectAndCompute(grey, mats.mat(), points, descriptors);
      return new Features(points.toArray(), descriptors);
    }
  }
}
