package org.hificamsim.agents.choice;

import org.hificamsim.core.policy.NetworkView;

/**
 * Pan angles by number, 0 the first: where they stand among a camera's views, and which of them is
 * nearest to a direction.
 */
public final class PanAngles {
  private PanAngles() {}

  /** The number of pan angles, 1 or more. */
  public static int count(NetworkView network, int camera) {
    return network.views(camera) / network.zooms(camera);
  }

  /** The pan angle of a view. */
  public static int of(NetworkView network, int camera, int view) {
    return view / network.zooms(camera);
  }

  /** The view with this pan angle and zoom level. */
  public static int view(NetworkView network, int camera, int pan, int zoom) {
    return pan * network.zooms(camera) + zoom;
  }

  /** The view with this pan angle at the widest zoom level. */
  public static int widest(NetworkView network, int camera, int pan) {
    return view(network, camera, pan, network.zooms(camera) - 1);
  }

  /** The pan angle nearest to where the camera is mounted to look: the first of equally near. */
  public static int home(NetworkView network, int camera) {
    int home = 0;
    for (int pan = 1; pan < count(network, camera); pan++) {
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
    for (int pan = 1; pan < count(network, camera); pan++) {
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
    return network.pan(camera, view(network, camera, pan, 0));
  }
}
