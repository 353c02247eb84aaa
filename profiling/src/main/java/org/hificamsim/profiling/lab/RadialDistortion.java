package org.hificamsim.profiling.lab;

import org.hificamsim.profiling.opencv.Mats;
import org.opencv.core.Core;
import org.opencv.core.CvType;
import org.opencv.core.Mat;
import org.opencv.core.Scalar;
import org.opencv.imgproc.Imgproc;

/**
 * Radial lens distortion: a point of the picture at radius r (1 in the corners) shows what an ideal
 * lens would show at {@code r (1 + k r^2)}.
 *
 * @param k above 0 barrel, below 0 pincushion
 */
record RadialDistortion(double k) {
  private static final double WIDE = 0.010;
  private static final double NEUTRAL = 0.035;
  private static final double BARREL_AT_WIDE = 0.045;
  private static final double PINCUSHION_AT_LONG = -0.012;

  /** The largest outward displacement of {@link #typical}, as a share of the half-diagonal. */
  static final double MAX = BARREL_AT_WIDE;

  /** Returns the typical distortion of zoom lenses at a focal length (metres), times a factor. */
  static RadialDistortion typical(double focalLength, double factor) {
    double log = StrictMath.log(NEUTRAL / focalLength) / StrictMath.log(NEUTRAL / WIDE);
    double k = log > 0 ? BARREL_AT_WIDE * log : -PINCUSHION_AT_LONG * Math.max(log, -1);
    double positiveZero = 0.0;
    return new RadialDistortion(factor * k + positiveZero);
  }

  /** Returns the frame that this lens shows of the canvas, without the margin. */
  Mat frame(Mat canvas, Pinhole camera, int interpolation) {
    int width = camera.width();
    int height = camera.height();
    float[] row = new float[width * 2];
    double halfDiagonalSquared = (width * (double) width + height * (double) height) / 4;
    try (Mats mats = new Mats()) {
      Mat map = mats.own(new Mat(height, width, CvType.CV_32FC2));
      for (int y = 0; y < height; y++) {
        double down = y + 0.5 - height / 2.0;
        for (int x = 0; x < width; x++) {
          double right = x + 0.5 - width / 2.0;
          double stretch = 1 + k * (right * right + down * down) / halfDiagonalSquared;
          row[2 * x] = (float) (right * stretch + width / 2.0 - 0.5 + camera.margin());
          row[2 * x + 1] = (float) (down * stretch + height / 2.0 - 0.5 + camera.margin());
        }
        map.put(y, 0, row);
      }
      Mat frame = new Mat();
      Mat none = mats.mat();
      Imgproc.remap(canvas, frame, map, none, interpolation, Core.BORDER_REPLICATE, new Scalar(0));
      return frame;
    }
  }
}
