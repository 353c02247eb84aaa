package org.hificamsim.core.policy;

/** A policy that bounds what any policy could score in its run, with the time that moves take. */
public interface BoundedZoomPolicy extends ZoomPolicy {
  /** How far the bound exceeds the score that the policy reaches; known once the run has begun. */
  double reachableGap();
}
