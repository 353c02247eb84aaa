package org.hificamsim.core.metrics;

/** The chance of each camera to detect each target in a step, before luck is drawn. */
public interface DetectionChances {
  /** The number of cameras that there will ever be. */
  int cameras();

  /** The number of targets that there will ever be. */
  int targets();

  /** Whether the target has appeared and not been removed. */
  boolean present(int target);

  /**
   * Lists the targets that the camera may detect through its current view.
   *
   * @param targets receives the targets, from index 0; as long as there are targets
   * @param chances receives the chance of each of them, in (0, 1]
   * @return the number of targets listed
   */
  int chances(int camera, int[] targets, double[] chances);
}
