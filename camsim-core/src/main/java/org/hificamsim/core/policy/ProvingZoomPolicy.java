package org.hificamsim.core.policy;

/**
 * A bound that searches for the best score of each step (k_min, Eq 7.1, unless the network has
 * another objective), and counts the steps whose search ended without a proof.
 */
public interface ProvingZoomPolicy extends OraclePolicy {
  /** The number of steps so far whose configuration is not proven to be optimal. */
  long unprovenSteps();

  /** An upper bound of what the scores of these steps could gain in total. */
  double gap();

  /** Whether the score is the least expected coverage, before luck is drawn. */
  default boolean ofExpectation() {
    return false;
  }
}
