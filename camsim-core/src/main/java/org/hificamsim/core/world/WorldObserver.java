package org.hificamsim.core.world;

/** Observes what events change in a world, in the order of the events. */
public interface WorldObserver {
  /** The observer that ignores everything. */
  WorldObserver NONE = new WorldObserver() {};

  /** A camera was added. */
  default void cameraAdded(int camera) {}

  /** A camera was given another range. */
  default void rangeChanged(int camera) {}

  /**
   * A camera was switched off.
   *
   * @param duration the duration, steps, above 0; -1 for the rest of the run
   */
  default void cameraFailed(int camera, int duration) {}

  /** A target appeared. */
  default void targetAppeared(int target) {}

  /** A target disappeared. */
  default void targetVanished(int target) {}
}
