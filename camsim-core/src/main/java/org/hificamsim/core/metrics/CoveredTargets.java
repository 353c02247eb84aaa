package org.hificamsim.core.metrics;

/** Targets, numbered from 0, with the number of cameras that cover each. */
public interface CoveredTargets {
  /** The number of targets that there will ever be. */
  int targets();

  /** Whether the target has appeared and not been removed. */
  boolean present(int target);

  /**
   * Returns the number of cameras that detected the target at the last observation: k_j of thesis
   * 7.1.
   */
  int coverage(int target);
}
