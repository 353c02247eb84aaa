package org.hificamsim.worlds;

import org.hificamsim.core.policy.NetworkView;

/**
 * The wanted directions of cameras that are steered by rates: any angle between the outermost pan
 * angles, and any value between two zoom levels. Cameras get the nearest view.
 */
final class Steering {
  /** The wanted pan angle of each camera, in radians. */
  private final double[] pan;

  /** The wanted zoom level of each camera, including fractions of a level. */
  private final double[] zoom;

  /** Starts with the current views of the cameras. */
  Steering(NetworkView network) {
    pan = new double[network.cameras()];
    zoom = new double[network.cameras()];
    for (int camera = 0; camera < pan.length; camera++) {
      setView(network, camera, network.view(camera));
    }
  }

  /** Sets the wanted direction of a camera to that of a view. */
  void setView(NetworkView network, int camera, int view) {
    pan[camera] = network.pan(camera, view);
    zoom[camera] = network.zoomOf(camera, view);
  }

  /**
   * Moves the wanted direction for one step, and returns the nearest view. A camera that turns in
   * no time moves at most one pan angle and one zoom level per step.
   *
   * @param turn the share of the greatest turn, from -1 (left) to 1 (right)
   * @param wider the share of the greatest zoom, from -1 (narrower) to 1 (wider)
   */
  int move(NetworkView network, int camera, double turn, double wider) {
    int last = network.pans(camera) - 1;
    double least = network.pan(camera, 0);
    double most = network.pan(camera, network.viewAt(camera, last, 0));
    double gap = (most - least) / Math.max(1, last);
    pan[camera] =
        clamp(pan[camera] + turn * finiteOr(network.turnInStep(camera), gap), least, most);
    double levels = wider * finiteOr(network.zoomInStep(camera), 1);
    zoom[camera] = clamp(zoom[camera] + levels, 0, network.zooms(camera) - 1);
    return network.viewAt(camera, nearest(network, camera), (int) Math.round(zoom[camera]));
  }

  private static double finiteOr(double speed, double instantMove) {
    return speed < Double.POSITIVE_INFINITY ? speed : instantMove;
  }

  private static double clamp(double value, double least, double most) {
    return Math.max(least, Math.min(most, value));
  }

  /**
   * Returns the number of the pan angle nearest to the wanted one, among those with the current
   * tilt.
   */
  private int nearest(NetworkView network, int camera) {
    double tilt = network.zoom(camera, network.view(camera)).vertical().tilt();
    int nearest = network.panOf(camera, network.view(camera));
    for (int number = 0; number < network.pans(camera); number++) {
      boolean hasCurrentTilt =
          network.zoom(camera, network.viewAt(camera, number, 0)).vertical().tilt() == tilt;
      nearest =
          hasCurrentTilt && distance(network, camera, number) < distance(network, camera, nearest)
              ? number
              : nearest;
    }
    return nearest;
  }

  private double distance(NetworkView network, int camera, int number) {
    return Math.abs(network.pan(camera, network.viewAt(camera, number, 0)) - pan[camera]);
  }
}
