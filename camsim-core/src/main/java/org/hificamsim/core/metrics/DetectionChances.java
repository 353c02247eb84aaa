package org.hificamsim.core.metrics;

/** How likely each camera was to detect each target in a step, before luck was drawn. */
public interface DetectionChances {
  /** How many cameras there will ever be. */
  int cameras();

  /** How many targets there will ever be. */
  int targets();

  /** Whether the target has appeared and not been removed. */
  boolean present(int target);

  /**
   * The targets that the camera may detect as it is.
   *
   * @param targets as long as there are targets; filled from the start
   * @param chances one entry for each of them, (0, 1]
   * @return how many there are
   */
  int chances(int camera, int[] targets, double[] chances);
}
