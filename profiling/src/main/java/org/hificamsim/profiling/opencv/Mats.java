package org.hificamsim.profiling.opencv;

import java.util.ArrayDeque;
import java.util.Deque;
import org.opencv.core.Mat;

/**
 * The native images of one piece of work, released together: Java's collector does not see their
 * size, so that waiting for it would fill the memory.
 */
public final class Mats implements AutoCloseable {
  private final Deque<Mat> owned = new ArrayDeque<>();

  /** A new, empty image that this owns. */
  public Mat mat() {
    return own(new Mat());
  }

  /** Takes over an image. */
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
