package org.hificamsim.agents.baseline;

import org.hificamsim.core.policy.NetworkView;

/** A camera's way over its pan angles, back and forth. */
final class PanPatrol {
  private final int dwell;
  private int left;
  private int direction = 1;

  /**
   * @param dwell steps that the camera stays in each view, 1 or more
   */
  PanPatrol(int dwell) {
    this.dwell = dwell;
    left = dwell;
  }

  /** The camera's next view; first of all one with the zoom level that was asked for. */
  int next(NetworkView network, int camera, int zoom) {
    int view = network.view(camera);
    int pan = network.panOf(camera, view);
    boolean zoomed = view != network.viewAt(camera, pan, zoom);
    if (!zoomed && left > 0) {
      left--;
      return view;
    }
    left = dwell - 1;
    int next = zoomed ? pan : turn(pan, network.pans(camera));
    return network.viewAt(camera, next, zoom);
  }

  private int turn(int pan, int pans) {
    if (pans == 1) {
      return pan;
    }
    boolean atEnd = pan + direction < 0 || pan + direction >= pans;
    direction = atEnd ? -direction : direction;
    return pan + direction;
  }
}
