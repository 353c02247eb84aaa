package org.hificamsim.profiling.detector;

import org.opencv.core.Mat;

/**
 * A local feature extractor (thesis 5.2): an extension point, found by {@link #name}.
 *
 * <p>An implementer writes all but {@link #close}. An instance serves one thread.
 */
public interface FeatureDetector extends AutoCloseable {
  /** The short name in files, such as {@code orb}. */
  String name();

  /** The features of a picture of 8-bit grey; the caller closes them. */
  Features detect(Mat grey);

  @Override
  default void close() {}
}
