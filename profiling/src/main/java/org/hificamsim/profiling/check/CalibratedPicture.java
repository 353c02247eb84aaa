package org.hificamsim.profiling.check;

/**
 * A calibrated camera and the size of its picture.
 *
 * @param width pixels
 * @param height pixels
 */
record CalibratedPicture(Calibration camera, int width, int height) {
  /** Whether the picture's border may have cut a box off. */
  boolean cuts(double left, double top, double right, double bottom) {
    return left <= 0 || top <= 0 || right >= width || bottom >= height;
  }
}
