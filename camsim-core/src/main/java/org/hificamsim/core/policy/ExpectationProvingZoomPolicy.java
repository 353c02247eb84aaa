package org.hificamsim.core.policy;

/**
 * A policy that looks for the best least expected coverage of each step, before luck is drawn, and
 * says where it ended its search before it had proven that it found it.
 */
public interface ExpectationProvingZoomPolicy extends ZoomPolicy {
  /** The number of steps so far whose configuration is not proven to be the best. */
  long unprovenSteps();

  /** What those steps' least expected coverage might gain at most, all steps together. */
  double gap();
}
