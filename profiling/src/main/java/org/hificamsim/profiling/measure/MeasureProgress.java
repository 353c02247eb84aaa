package org.hificamsim.profiling.measure;

/** Receives the progress of a measurement; may be called from any thread. */
@FunctionalInterface
public interface MeasureProgress {
  /** Called after each photo. */
  void advance();

  /** Called first, with the number of photos that an earlier call has measured. */
  default void resume(long photos) {}
}
