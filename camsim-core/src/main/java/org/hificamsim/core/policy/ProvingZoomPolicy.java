package org.hificamsim.core.policy;

/**
 * A policy that looks for the best score of each step (k_min, Eq 7.1, unless the network has
 * another objective), and says where it ended its search before it had proven that it found it.
 */
public interface ProvingZoomPolicy extends OraclePolicy {
  /** The number of steps so far whose configuration is not proven to be the best. */
  long unprovenSteps();

  /** What those steps' scores might gain at most, all steps together. */
  double gap();

  /** Whether the score is the least expected coverage, before luck is drawn. */
  default boolean ofExpectation() {
    return false;
  }
}
