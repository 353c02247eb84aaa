package org.hificamsim.agents.choice;

import org.hificamsim.core.policy.NetworkView;

/** Finds the number of a camera's pan angle that is nearest to a direction. */
public final class PanAngles {
  private PanAngles() {}

  /** Returns the pan angle nearest to the camera's heading; of equally near ones the first. */
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
   * Returns the pan angle nearest to a direction, across the whole turn; of equally near ones the
   * first.
   *
   * @param direction radians off the camera's heading, to the right
   */
  public static int nearest(NetworkView network, int camera, double direction) {
    int nearest = 0;
    double least = difference(network, camera, 0, direction);
    for (int pan = 1; pan < network.pans(camera); pan++) {
      double difference = difference(network, camera, pan, direction);
      nearest = difference < least ? pan : nearest;
      least = Math.min(difference, least);
    }
    return nearest;
  }

  /** Returns the angle between a direction and a pan angle, radians in [0, pi]. */
  public static double difference(NetworkView network, int camera, int pan, double direction) {
    double difference = direction - angle(network, camera, pan);
    return Math.abs(Math.IEEEremainder(difference, 2 * Math.PI));
  }

  private static double angle(NetworkView network, int camera, int pan) {
    return network.pan(camera, network.viewAt(camera, pan, 0));
  }
}
