package org.hificamsim.profiling.detector;

import org.opencv.core.KeyPoint;
import org.opencv.core.Mat;

/**
 * The features of one picture.
 *
 * @param points where they are
 * @param descriptors one row each, in the same order; 8-bit or 32-bit float
 */
public record Features(KeyPoint[] points, Mat descriptors) implements AutoCloseable {
  /** How many there are. */
  public int count() {
    return points.length;
  }

  @Override
  public void close() {
    descriptors.release();
  }
}
