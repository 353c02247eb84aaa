package org.hificamsim.profiling.lab;

import org.opencv.core.Mat;

/**
 * A picture and the silhouette of its object.
 *
 * @param image 8 bits, BGR
 * @param mask 255 where the object is, before blur
 * @param conditions what it was taken under
 */
record Photo(Mat image, Mat mask, Conditions conditions) implements AutoCloseable {
  @Override
  public void close() {
    image.release();
    mask.release();
  }
}
