package org.hificamsim.core.policy;

/**
 * A policy that looks for the best k_min of each step (Eq 7.1), and tells where it ended its search
 * before it had proven that it found it.
 */
public interface ProvingZoomPolicy extends ZoomPolicy {
  /** The number of steps so far whose configuration is not proven to be the best. */
  long unprovenSteps();

  /** What those steps' k_min might gain at most, all steps together. */
  long gap();
}
