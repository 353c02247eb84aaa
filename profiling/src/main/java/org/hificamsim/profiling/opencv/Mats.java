package org.hificamsim.profiling.opencv;

import java.util.ArrayDeque;
import java.util.Deque;
import org.opencv.core.Mat;

/**
 * Native images that are released together. Java's garbage collector does not know their size, so
 * relying on it would fill the memory.
 */
public final class Mats implements AutoCloseable {
  private final Deque<Mat> owned = new ArrayDeque<>();

  /** Creates an empty image that this object owns. */
  public Mat mat() {
    return own(new Mat());
  }

  /** Takes ownership of an image and returns it. */
  public <M extends Mat> M own(M mat) {
    owned.push(mat);
    return mat;
  }

  @Override
  public void close() {
    owned.forEach(Mat::release);
    owned.clear();
  }
}
