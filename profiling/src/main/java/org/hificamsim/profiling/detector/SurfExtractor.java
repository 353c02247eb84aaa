package org.hificamsim.profiling.detector;

import boofcv.abst.feature.detdesc.DetectDescribePoint;
import boofcv.abst.feature.detect.interest.ConfigFastHessian;
import boofcv.factory.feature.detdesc.FactoryDetectDescribe;
import boofcv.struct.feature.TupleDesc_F64;
import boofcv.struct.image.GrayU8;
import georegression.struct.point.Point2D_F64;
import org.opencv.core.CvType;
import org.opencv.core.KeyPoint;
import org.opencv.core.Mat;

/** Speeded-up robust features (thesis 5.6) by BoofCV, since Debian's OpenCV has none. */
final class SurfExtractor implements FeatureDetector.Extractor {
  /** The blob response below which nothing counts as a feature; BoofCV's scale, for 8-bit grey. */
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
      Point2D_F64 at = detector.getLocation(i);
      float size = (float) (2 * detector.getRadius(i));
      points[i] = new KeyPoint((float) at.x, (float) at.y, size);
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
