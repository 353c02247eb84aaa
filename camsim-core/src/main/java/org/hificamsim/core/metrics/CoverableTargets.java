package org.hificamsim.core.metrics;

/** Targets of which is known, too, what could cover them. */
public interface CoverableTargets extends CoveredTargets {
  /**
   * Marks the targets present that some online camera at some of its views would detect where both
   * are now.
   *
   * @param coverable one entry for each target; all are overwritten
   */
  void markCoverable(boolean[] coverable);
}
