package org.hificamsim.runs.compare;

/** Receives how far a comparison is. */
@FunctionalInterface
public interface RunProgress {
  /** One more run is finished; called from any thread. */
  void advance();

  /**
   * Some runs were finished by an earlier call; called once, before any other.
   *
   * @param runs how many, 0 or more
   */
  default void resume(long runs) {}
}
