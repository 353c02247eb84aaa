package org.hificamsim.profiling.measure;

import org.hificamsim.profiling.opencv.Mats;
import org.opencv.core.KeyPoint;
import org.opencv.core.Mat;
import org.opencv.core.MatOfKeyPoint;
import org.opencv.core.Size;
import org.opencv.features2d.FastFeatureDetector;
import org.opencv.imgproc.Imgproc;

/**
 * How distinctive a template is: the share of the cells of a grid over it that have a corner. It
 * grows with the number of features and with their spread; the template is brought to one size
 * before.
 */
final class Distinctiveness {
  private static final int CELLS = 16;
  private static final int PIXELS_PER_CELL = 16;
  private static final int SIDE = CELLS * PIXELS_PER_CELL;

  private Distinctiveness() {}

  /** Of a picture in 8-bit grey, [0, 1]. */
  static double of(Mat grey) {
    try (Mats mats = new Mats()) {
      Mat square = mats.mat();
      Imgproc.resize(grey, square, new Size(SIDE, SIDE), 0, 0, Imgproc.INTER_AREA);
      MatOfKeyPoint corners = mats.own(new MatOfKeyPoint());
      FastFeatureDetector.create().detect(square, corners);
      boolean[] taken = new boolean[CELLS * CELLS];
      int count = 0;
      for (KeyPoint corner : corners.toArray()) {
        int cell =
            (int) corner.pt.y / PIXELS_PER_CELL * CELLS + (int) corner.pt.x / PIXELS_PER_CELL;
        count += taken[cell] ? 0 : 1;
        taken[cell] = true;
      }
      return count / (double) taken.length;
    }
  }
}
