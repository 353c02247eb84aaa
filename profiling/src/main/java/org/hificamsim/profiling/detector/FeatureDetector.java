package org.hificamsim.profiling.detector;

import boofcv.abst.feature.detdesc.DetectDescribePoint;
import boofcv.abst.feature.detect.interest.ConfigFastHessian;
import boofcv.factory.feature.detdesc.FactoryDetectDescribe;
import boofcv.struct.feature.TupleDesc_F64;
import boofcv.struct.image.GrayU8;
import georegression.struct.point.Point2D_F64;
import java.util.function.Supplier;
import org.hificamsim.core.Spelling;
import org.hificamsim.profiling.opencv.Mats;
import org.opencv.core.CvType;
import org.opencv.core.KeyPoint;
import org.opencv.core.Mat;
import org.opencv.core.MatOfKeyPoint;
import org.opencv.features2d.Feature2D;

/** The local feature detectors of thesis 5.2, in its order. */
@SuppressWarnings("ImmutableEnumChecker") // the lambdas have no state
public enum FeatureDetector {
  /** Oriented FAST and rotated BRIEF with OpenCV's defaults: 500 features (thesis 5.4). */
  ORB(new Memory(20, 0), () -> openCv(org.opencv.features2d.ORB.create())),
  /**
   * The scale-invariant feature transform with OpenCV's defaults (thesis 5.5). It doubles the size
   * of the picture and keeps two pyramids of it in 32 bits.
   */
  SIFT(new Memory(250, 0), () -> openCv(org.opencv.features2d.SIFT.create())),
  /** Speeded-up robust features (thesis 5.6). */
  SURF(new Memory(2, 50), SurfExtractor::new);

  /** Finds features in pictures. Not thread-safe. */
  public interface Extractor {
    /** Returns the features of a picture in 8-bit grey; the caller closes them. */
    Features features(Mat grey);
  }

  private final Memory need;
  private final Supplier<Extractor> extractorSupplier;

  FeatureDetector(Memory need, Supplier<Extractor> extractorSupplier) {
    this.need = need;
    this.extractorSupplier = extractorSupplier;
  }

  /** Returns its name in files and options. */
  public String word() {
    return Spelling.of(this);
  }

  /** Returns the memory that it needs for each pixel of a photo. */
  Memory need() {
    return need;
  }

  /** Creates an extractor. */
  public Extractor extractor() {
    return extractorSupplier.get();
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

  /** Speeded-up robust features (thesis 5.6) by BoofCV, since Debian's OpenCV has none. */
  static final class SurfExtractor implements FeatureDetector.Extractor {
    /** The least blob response of a feature, on BoofCV's scale for 8-bit grey. */
    private static final float MIN_RESPONSE = 12;

    private final DetectDescribePoint<GrayU8, TupleDesc_F64> detector;

    SurfExtractor() {
      ConfigFastHessian config = new ConfigFastHessian();
      config.extract.threshold = MIN_RESPONSE;
      detector = FactoryDetectDescribe.surfFast(config, null, null, GrayU8.class);
    }

    @Override
    public Features features(Mat grey) {
      GrayU8 image = new GrayU8(grey.cols(), grey.rows());
      grey.get(0, 0, image.data);
      detector.detect(image);
      int count = detector.getNumberOfFeatures();
      KeyPoint[] points = new KeyPoint[count];
      float[] values = new float[count * length()];
      for (int i = 0; i < count; i++) {
        Point2D_F64 location = detector.getLocation(i);
        float size = (float) (2 * detector.getRadius(i));
        points[i] = new KeyPoint((float) location.x, (float) location.y, size);
        double[] descriptor = detector.getDescription(i).data;
        for (int j = 0; j < descriptor.length; j++) {
          values[i * length() + j] = (float) descriptor[j];
        }
      }
      Mat descriptors = new Mat(count, length(), CvType.CV_32F);
      if (count > 0) {
        descriptors.put(0, 0, values);
      }
      return new Features(points, descriptors);
    }

    private int length() {
      return detector.createDescription().size();
    }
  }
}
