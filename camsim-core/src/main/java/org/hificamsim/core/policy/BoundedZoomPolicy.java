package org.hificamsim.core.policy;

/** A policy that bounds the score of all policies in its run, whose moves take time. */
public interface BoundedZoomPolicy extends ZoomPolicy {
  /** How far the bound exceeds the score that the policy reaches; known once the run has begun. */
  double reachableGap();
}
