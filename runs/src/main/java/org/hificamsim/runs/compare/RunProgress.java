package org.hificamsim.runs.compare;

/** Receives the progress of a comparison. */
@FunctionalInterface
public interface RunProgress {
  /** Called from any thread when a run is finished. */
  void advance();

  /**
   * Called once, before any other call, with the runs that an earlier call has finished.
   *
   * @param runs their number, 0 or more
   */
  default void resume(long runs) {}
}
