package org.hificamsim.agents.cooperative;

import java.util.Arrays;
import org.hificamsim.core.policy.NetworkView;

/** What a camera would detect of a forecast in each of its views, and when it gets there. */
final class ViewForecast {
  private static final int FIRST_ROWS = 16;

  private int views;
  private int[] delays = {}; // by view: steps until it sees through it
  private double[] now = {};
  private int rows;
  private int[] slots = {}; // in which it detects something in some view
  private double[] chances = {}; // by row and view

  /** Looks at all slots of a forecast from where the camera is now. */
  void update(NetworkView network, int camera, Belief belief, Forecast forecast) {
    prepare(network, camera);
    rows = 0;
    for (int slot = 0; slot < forecast.slots(); slot++) {
      double x = forecast.x(slot);
      double y = forecast.y(slot);
      if (belief.chances(network, camera, x, y, forecast.size(slot), now)) {
        add(slot, forecast.step(slot));
      }
    }
  }

  private void prepare(NetworkView network, int camera) {
    views = network.views(camera);
    if (now.length != views) {
      now = new double[views];
      delays = new int[views];
    }
    for (int view = 0; view < views; view++) {
      delays[view] = network.stepsTo(camera, view);
    }
  }

  private void add(int slot, int step) {
    if (rows == slots.length) {
      slots = Arrays.copyOf(slots, Math.max(FIRST_ROWS, 2 * rows));
    }
    if (chances.length < (rows + 1) * views) {
      chances = Arrays.copyOf(chances, slots.length * views);
    }
    double most = 0;
    for (int view = 0; view < views; view++) {
      double chance = delays[view] <= step ? now[view] : 0;
      chances[rows * views + view] = chance;
      most = Math.max(most, chance);
    }
    slots[rows] = slot;
    rows += most > 0 ? 1 : 0;
  }

  /** How many targets and steps there are that the camera detects in some view. */
  int rows() {
    return rows;
  }

  /** One of them, as a slot of the forecast. */
  int slot(int row) {
    return slots[row];
  }

  /** How likely it is detected in a view. */
  double chance(int row, int view) {
    return chances[row * views + view];
  }

  /** How many steps pass before the camera sees through a view. */
  int delay(int view) {
    return delays[view];
  }

  /** Adds what the camera covers in a view, or takes it back. */
  void cover(int view, PlannedCoverage coverage, boolean added) {
    for (int row = 0; row < rows; row++) {
      double chance = chances[row * views + view];
      if (chance > 0 && added) {
        coverage.add(slots[row], chance);
      } else if (chance > 0) {
        coverage.remove(slots[row], chance);
      }
    }
  }

  /** What each view adds to what is covered. */
  void gains(Forecast forecast, PlannedCoverage coverage, double[] gains) {
    Arrays.fill(gains, 0, views, 0);
    for (int row = 0; row < rows; row++) {
      double worth = forecast.weight(slots[row]) * coverage.added(slots[row]);
      for (int view = 0; view < views && worth > 0; view++) {
        gains[view] += worth * chances[row * views + view];
      }
    }
  }
}
