package org.hificamsim.profiling.detector;

import java.util.List;

/**
 * A detector that knows what it looks for without a template: people, faces, a class of a network.
 * An instance serves one thread.
 */
interface BoxDetector extends AutoCloseable {
  /** Every rectangle that it takes for what it looks for. */
  List<Box> detect(Photograph photo);

  @Override
  default void close() {}
}
