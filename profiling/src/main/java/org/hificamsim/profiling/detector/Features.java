package org.hificamsim.profiling.detector;

import org.opencv.core.KeyPoint;
import org.opencv.core.Mat;

/**
 * The features of one picture.
 *
 * @param points the position, size and direction of each feature
 * @param descriptors one row each, in the same order; 8-bit or 32-bit float
 */
public record Features(KeyPoint[] points, Mat descriptors) implements AutoCloseable {
  /** Returns the number of features. */
  public int count() {
    return points.length;
  }

  @Override
  public void close() {
    descriptors.release();
  }
}
