package org.hificamsim.core.policy;

/** A policy that bounds the score of all policies in its run, whose moves take time. */
public interface BoundedZoomPolicy extends ZoomPolicy {
  /**
   * Returns the difference between the bound and the score that the policy reaches; it is known
   * once the run has begun.
   */
  double reachableGap();
}
