package org.hificamsim.agents.cooperative;

import java.util.Arrays;
import org.hificamsim.core.policy.NetworkView;

/**
 * How many steps a camera is on its way between any two of its views before the first step that it
 * sees through the second one. It follows from the camera's speeds; {@link NetworkView#stepsTo}
 * says the same from where the camera is now.
 */
final class MoveTimes {
  /** Allows for rounding: five steps of a fifth make a whole. */
  private static final double ROUNDING = 1 + 1e-6;

  /** The numbers that describe a view: its pan angle, tilt and zoom level. */
  private static final int NUMBERS = 3;

  /** By camera, then by view and view. */
  private final int[][] steps;

  /** By camera: what its times follow from, the numbers of its views and its speeds. */
  private final double[][] lenses;

  MoveTimes(int cameras) {
    steps = new int[cameras][0];
    lenses = new double[cameras][0];
  }

  /** Computes the times of all cameras whose views or speeds have changed. */
  void update(NetworkView network) {
    for (int camera = 0; camera < steps.length; camera++) {
      if (!isKnown(network, camera)) {
        lenses[camera] = lens(network, camera);
        steps[camera] = steps(lenses[camera], network.views(camera));
      }
    }
  }

  private boolean isKnown(NetworkView network, int camera) {
    double[] lens = lenses[camera];
    int views = network.views(camera);
    boolean known =
        lens.length == NUMBERS * views + 2
            && lens[lens.length - 2] == network.turnInStep(camera)
            && lens[lens.length - 1] == network.zoomInStep(camera);
    for (int view = 0; view < views && known; view++) {
      known =
          lens[NUMBERS * view] == network.pan(camera, view)
              && lens[NUMBERS * view + 1] == tilt(network, camera, view)
              && lens[NUMBERS * view + 2] == network.zoomOf(camera, view);
    }
    return known;
  }

  private static double[] lens(NetworkView network, int camera) {
    int views = network.views(camera);
    double[] lens = new double[NUMBERS * views + 2];
    for (int view = 0; view < views; view++) {
      lens[NUMBERS * view] = network.pan(camera, view);
      lens[NUMBERS * view + 1] = tilt(network, camera, view);
      lens[NUMBERS * view + 2] = network.zoomOf(camera, view);
    }
    lens[lens.length - 2] = network.turnInStep(camera);
    lens[lens.length - 1] = network.zoomInStep(camera);
    return lens;
  }

  private static double tilt(NetworkView network, int camera, int view) {
    return network.zoom(camera, view).vertical().tilt();
  }

  private static int[] steps(double[] lens, int views) {
    int[] steps = new int[views * views];
    Arrays.setAll(steps, pair -> steps(lens, NUMBERS * (pair / views), NUMBERS * (pair % views)));
    return steps;
  }

  private static int steps(double[] lens, int from, int to) {
    double panning = Math.abs(lens[to] - lens[from]);
    double tilting = Math.abs(lens[to + 1] - lens[from + 1]);
    double zooming = Math.abs(lens[to + 2] - lens[from + 2]);
    double turningSteps = Math.max(panning, tilting) / lens[lens.length - 2];
    double zoomingSteps = zooming / lens[lens.length - 1];
    double needed = Math.max(turningSteps, zoomingSteps) / ROUNDING;
    return (int) Math.max(0, Math.ceil(needed) - 1);
  }

  /** By view and view, the steps that a camera is on its way from the first to the second one. */
  int[] of(int camera) {
    return steps[camera];
  }
}
