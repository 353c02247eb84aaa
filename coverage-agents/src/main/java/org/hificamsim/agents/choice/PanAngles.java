package org.hificamsim.agents.choice;

import org.hificamsim.core.policy.NetworkView;

/** Which of a camera's pan angles, by number, is nearest to a direction. */
public final class PanAngles {
  private PanAngles() {}

  /** The pan angle nearest to where the camera is mounted to look: the first of equally near. */
  public static int home(NetworkView network, int camera) {
    int home = 0;
    for (int pan = 1; pan < network.pans(camera); pan++) {
      boolean nearer =
          Math.abs(angle(network, camera, pan)) < Math.abs(angle(network, camera, home));
      home = nearer ? pan : home;
    }
    return home;
  }

  /**
   * The pan angle nearest to a direction, all round: the first of equally near.
   *
   * @param direction radians off the camera's heading, to the right
   */
  public static int nearest(NetworkView network, int camera, double direction) {
    int nearest = 0;
    double least = off(network, camera, 0, direction);
    for (int pan = 1; pan < network.pans(camera); pan++) {
      double off = off(network, camera, pan, direction);
      nearest = off < least ? pan : nearest;
      least = Math.min(off, least);
    }
    return nearest;
  }

  /** How far a direction is off a pan angle, radians in [0, pi]. */
  public static double off(NetworkView network, int camera, int pan, double direction) {
    double off = direction - angle(network, camera, pan);
    return Math.abs(Math.IEEEremainder(off, 2 * Math.PI));
  }

  private static double angle(NetworkView network, int camera, int pan) {
    return network.pan(camera, network.viewAt(camera, pan, 0));
  }
}
