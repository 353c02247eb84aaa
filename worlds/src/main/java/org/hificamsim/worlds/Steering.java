package org.hificamsim.worlds;

import org.hificamsim.core.policy.NetworkView;

/**
 * Where cameras that are steered by rates are to look: at any angle between their outermost pan
 * angles, at any place between two zoom levels. What they get of it is the nearest view.
 */
final class Steering {
  private final double[] pan; // radians
  private final double[] zoom; // levels

  /** At the views that cameras have. */
  Steering(NetworkView network) {
    pan = new double[network.cameras()];
    zoom = new double[network.cameras()];
    for (int camera = 0; camera < pan.length; camera++) {
      at(network, camera, network.view(camera));
    }
  }

  /** Looks where a view does. */
  void at(NetworkView network, int camera, int view) {
    pan[camera] = network.pan(camera, view);
    zoom[camera] = network.zoomOf(camera, view);
  }

  /**
   * Moves for a step, and says to which view that comes. A camera that turns at once turns by one
   * pan angle in a step, and its lens changes by one level.
   *
   * @param turn part of the most, from -1, to the left, to 1
   * @param wider the same of its lens, from -1, narrower, to 1
   */
  int moved(NetworkView network, int camera, double turn, double wider) {
    int last = network.pans(camera) - 1;
    double least = network.pan(camera, 0);
    double most = network.pan(camera, network.viewAt(camera, last, 0));
    double gap = (most - least) / Math.max(1, last);
    pan[camera] = within(pan[camera] + turn * finite(network.turnInStep(camera), gap), least, most);
    double levels = wider * finite(network.zoomInStep(camera), 1);
    zoom[camera] = within(zoom[camera] + levels, 0, network.zooms(camera) - 1);
    return network.viewAt(camera, nearest(network, camera), (int) Math.round(zoom[camera]));
  }

  private static double finite(double speed, double atOnce) {
    return speed < Double.POSITIVE_INFINITY ? speed : atOnce;
  }

  private static double within(double value, double least, double most) {
    return Math.max(least, Math.min(most, value));
  }

  /** The pan angle nearest to where the camera is to look, at the tilt that it has. */
  private int nearest(NetworkView network, int camera) {
    double tilt = network.zoom(camera, network.view(camera)).vertical().tilt();
    int nearest = network.panOf(camera, network.view(camera));
    for (int number = 0; number < network.pans(camera); number++) {
      boolean level =
          network.zoom(camera, network.viewAt(camera, number, 0)).vertical().tilt() == tilt;
      nearest =
          level && off(network, camera, number) < off(network, camera, nearest) ? number : nearest;
    }
    return nearest;
  }

  private double off(NetworkView network, int camera, int number) {
    return Math.abs(network.pan(camera, network.viewAt(camera, number, 0)) - pan[camera]);
  }
}
