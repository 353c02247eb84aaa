package org.hificamsim.core.metrics;

/** Targets for which it is known whether any camera could cover them. */
public interface CoverableTargets extends CoveredTargets {
  /**
   * Marks the present targets that some online camera would detect now through some view.
   *
   * @param coverable receives one entry for each target
   */
  void markCoverable(boolean[] coverable);
}
