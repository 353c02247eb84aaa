package org.hificamsim.network.bandit;

import org.hificamsim.network.statistics.CameraFigures;

/** Learns for one camera, once per step while the camera is online. */
public interface CameraBandit {
  /** The bandit of a camera that does not learn. */
  CameraBandit NONE = new CameraBandit() {};

  /** Chooses before the auctions; returns whether CamSim counts this as a change of strategy. */
  default boolean choose() {
    return false;
  }

  /**
   * Returns the utility and prices that the camera has earned before it settles its auctions; 0 if
   * the bandit does not learn from them.
   */
  default double earned(CameraFigures figures) {
    return 0;
  }

  /** Called when an event has changed the range of the camera. */
  default void rangeChanged() {}

  /**
   * Learns, after the camera has settled its auctions.
   *
   * @param earned the result of {@link #earned} in this step
   * @param attempts the number of StartSearch messages that the camera attempted
   * @param figures the figures measured for this camera
   */
  default void learn(double earned, int attempts, CameraFigures figures) {}
}
