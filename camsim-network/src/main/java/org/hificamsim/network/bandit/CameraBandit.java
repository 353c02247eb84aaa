package org.hificamsim.network.bandit;

import org.hificamsim.network.statistics.CameraFigures;

/** What a camera learns with, once per step while it is online. */
public interface CameraBandit {
  /** A camera that does not learn. */
  CameraBandit NONE = new CameraBandit() {};

  /** Chooses before the auctions; whether CamSim counts that as a change of strategy. */
  default boolean choose() {
    return false;
  }

  /**
   * What the camera has earned, before it settles its auctions; 0 where that is not learned from.
   */
  default double earned(CameraFigures figures) {
    return 0;
  }

  /**
   * Learns, after the camera has settled its auctions.
   *
   * @param earned what {@link #earned} said in this step
   * @param sent how many StartSearch messages the camera attempted
   * @param figures measured for this camera
   */
  default void learn(double earned, int sent, CameraFigures figures) {}
}
