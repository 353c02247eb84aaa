package org.hificamsim.profiling.detector;

import java.util.function.Supplier;
import org.hificamsim.core.Spelling;
import org.hificamsim.profiling.opencv.Mats;
import org.opencv.core.Mat;
import org.opencv.core.MatOfKeyPoint;
import org.opencv.features2d.Feature2D;

/** The local feature detectors of thesis 5.2, in its order. */
@SuppressWarnings("ImmutableEnumChecker") // without state
public enum FeatureDetector {
  /** Oriented FAST and rotated BRIEF with OpenCV's defaults: 500 features (thesis 5.4). */
  ORB(new Memory(20, 0), () -> openCv(org.opencv.features2d.ORB.create())),
  /**
   * The scale-invariant feature transform with OpenCV's defaults (thesis 5.5). It keeps both
   * pyramids of a picture that is enlarged twice, in 32 bits.
   */
  SIFT(new Memory(250, 0), () -> openCv(org.opencv.features2d.SIFT.create())),
  /** Speeded-up robust features (thesis 5.6). */
  SURF(new Memory(2, 50), SurfExtractor::new);

  /** Finds features; an instance serves one thread. */
  public interface Extractor {
    /** The features of a picture of 8-bit grey; the caller closes them. */
    Features features(Mat grey);
  }

  private final Memory need;
  private final Supplier<Extractor> maker;

  FeatureDetector(Memory need, Supplier<Extractor> maker) {
    this.need = need;
    this.maker = maker;
  }

  /** Its name in files and options. */
  public String word() {
    return Spelling.of(this);
  }

  /** What it takes for each pixel of a photo. */
  Memory need() {
    return need;
  }

  /** A new one at work. */
  public Extractor extractor() {
    return maker.get();
  }

  private static Extractor openCv(Feature2D detector) {
    return grey -> {
      try (Mats mats = new Mats()) {
        MatOfKeyPoint points = mats.own(new MatOfKeyPoint());
        Mat descriptors = new Mat();
        detector.detectAndCompute(grey, mats.mat(), points, descriptors);
        return new Features(points.toArray(), descriptors);
      }
    };
  }
}
