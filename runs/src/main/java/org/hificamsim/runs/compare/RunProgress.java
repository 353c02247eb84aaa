package org.hificamsim.runs.compare;

/** Receives the progress of a comparison. */
@FunctionalInterface
public interface RunProgress {
  /** Called from any thread when a run is finished. */
  void advance();

  /**
   * Called once, before any other call, with the number of runs that need not be computed because
   * an earlier comparison has finished them.
   *
   * @param runs the number of these runs, 0 or more
   */
  default void resume(long runs) {}
}
