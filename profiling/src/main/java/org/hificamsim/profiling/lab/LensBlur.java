package org.hificamsim.profiling.lab;

import org.hificamsim.profiling.opencv.Mats;
import org.opencv.core.Core;
import org.opencv.core.CvType;
import org.opencv.core.Mat;
import org.opencv.core.Point;
import org.opencv.core.Scalar;
import org.opencv.core.Size;
import org.opencv.imgproc.Imgproc;

/** Spreads every pixel over a disc, as a lens out of focus does. */
final class LensBlur {
  private static final double WIDEST_KERNEL = 14;

  /** The factor by which discs are drawn larger before they are averaged down. */
  private static final int OVERSAMPLING = 8;

  private LensBlur() {}

  /**
   * Blurs an image in place.
   *
   * @param diameter the diameter of the disc, in pixels; below half a pixel the image is unchanged
   */
  static void apply(Mat image, double diameter) {
    if (diameter < 0.5) {
      return;
    }
    double shrink = Math.min(1, WIDEST_KERNEL / diameter);
    try (Mats mats = new Mats()) {
      Mat kernel = mats.own(disc(diameter * shrink));
      if (shrink == 1) {
        filter(image, image, kernel);
        return;
      }
      Mat small = mats.mat();
      Size size =
          new Size(
              Math.max(1, Math.round(image.cols() * shrink)),
              Math.max(1, Math.round(image.rows() * shrink)));
      Imgproc.resize(image, small, size, 0, 0, Imgproc.INTER_AREA);
      filter(small, small, kernel);
      Imgproc.resize(small, image, image.size(), 0, 0, Imgproc.INTER_LINEAR);
    }
  }

  private static void filter(Mat from, Mat to, Mat kernel) {
    Imgproc.filter2D(from, to, -1, kernel, new Point(-1, -1), 0, Core.BORDER_REPLICATE);
  }

  /** Returns a disc of total weight 1 with soft edges, drawn large and averaged down. */
  static Mat disc(double diameter) {
    int side = 2 * (int) Math.ceil((diameter - 1) / 2) + 1;
    Mat kernel = new Mat();
    try (Mats mats = new Mats()) {
      Mat large = mats.own(Mat.zeros(side * OVERSAMPLING, side * OVERSAMPLING, CvType.CV_32F));
      double centre = (side * OVERSAMPLING - 1) / 2.0;
      Imgproc.circle(
          large,
          new Point(centre, centre),
          (int) Math.round(diameter * OVERSAMPLING / 2),
          new Scalar(1),
          Core.FILLED);
      Imgproc.resize(large, kernel, new Size(side, side), 0, 0, Imgproc.INTER_AREA);
      Core.multiply(kernel, new Scalar(1 / Core.sumElems(kernel).val[0]), kernel);
    }
    return kernel;
  }
}
