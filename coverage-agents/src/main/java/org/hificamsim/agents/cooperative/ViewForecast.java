package org.hificamsim.agents.cooperative;

import java.util.Arrays;
import org.hificamsim.core.policy.NetworkView;

/** The expected detections of a camera in each of its views, and when it reaches the view. */
final class ViewForecast {
  private static final int FIRST_ROWS = 16;

  private int views;

  /** The number of steps until the camera sees through a view, by view. */
  private int[] delays = {};

  /** Scratch memory, by view. */
  private double[] viewChances = {};

  private int rows;

  /** The slot of each row's target in the forecast. */
  private int[] slots = {};

  /** The chance that the camera detects the target, by row and view. */
  private double[] chances = {};

  /** Computes the chances for all slots of a forecast, from the camera's present view on. */
  void update(NetworkView network, int camera, Belief belief, Forecast forecast) {
    prepare(network, camera);
    rows = 0;
    for (int slot = 0; slot < forecast.slots(); slot++) {
      double x = forecast.x(slot);
      double y = forecast.y(slot);
      if (belief.chances(network, camera, x, y, forecast.size(slot), viewChances)) {
        add(slot, forecast.step(slot), forecast.visibleShare(network, camera, slot));
      }
    }
  }

  private void prepare(NetworkView network, int camera) {
    views = network.views(camera);
    if (viewChances.length != views) {
      viewChances = new double[views];
      delays = new int[views];
    }
    for (int view = 0; view < views; view++) {
      delays[view] = network.stepsTo(camera, view);
    }
  }

  /** Adds a row, unless its chances are 0 in all views that the camera reaches in time. */
  private void add(int slot, int step, double visibleShare) {
    if (rows == slots.length) {
      slots = Arrays.copyOf(slots, Math.max(FIRST_ROWS, 2 * rows));
    }
    if (chances.length < (rows + 1) * views) {
      chances = Arrays.copyOf(chances, slots.length * views);
    }
    double greatest = 0;
    for (int view = 0; view < views; view++) {
      double chance = delays[view] <= step ? visibleShare * viewChances[view] : 0;
      chances[rows * views + view] = chance;
      greatest = Math.max(greatest, chance);
    }
    slots[rows] = slot;
    rows += greatest > 0 ? 1 : 0;
  }

  /** The number of slots in which the camera may detect the target, in any view: a row for each. */
  int rows() {
    return rows;
  }

  /** The slot of a row. */
  int slot(int row) {
    return slots[row];
  }

  /** The chance to detect the target of a row's slot in a view. */
  double chance(int row, int view) {
    return chances[row * views + view];
  }

  /** The number of steps until the camera sees through a view. */
  int delay(int view) {
    return delays[view];
  }

  /** Adds what the camera covers on its way to the planned coverage. */
  void addTo(PlannedCoverage coverage, int[] way) {
    for (int row = 0; row < rows; row++) {
      double chance = chance(row, way);
      if (chance > 0) {
        coverage.add(slots[row], chance);
      }
    }
  }

  /** Removes what the camera covers on its way from the planned coverage. */
  void removeFrom(PlannedCoverage coverage, int[] way) {
    for (int row = 0; row < rows; row++) {
      double chance = chance(row, way);
      if (chance > 0) {
        coverage.remove(slots[row], chance);
      }
    }
  }

  /** Adds what each view promises of known targets, beyond the planned coverage of the others. */
  void addTo(ViewOutlook outlook, Forecast forecast, PlannedCoverage coverage) {
    for (int row = 0; row < rows; row++) {
      double weight = forecast.weight(slots[row]);
      double others = coverage.covered(slots[row]);
      double added = coverage.added(slots[row]);
      for (int view = 0; view < views; view++) {
        outlook.addKnown(view, weight * chances[row * views + view], others, added);
      }
    }
  }

  private double chance(int row, int[] way) {
    int view = way[slots[row] % way.length];
    return view >= 0 ? chances[row * views + view] : 0;
  }

  /**
   * Adds what each view gains in each step beyond the planned coverage, which must not include the
   * camera.
   *
   * @param rewards the rewards by step and view
   */
  void addRewards(Forecast forecast, PlannedCoverage coverage, double[] rewards) {
    for (int row = 0; row < rows; row++) {
      double worth = forecast.weight(slots[row]) * coverage.added(slots[row]);
      int first = forecast.step(slots[row]) * views;
      for (int view = 0; view < views && worth > 0; view++) {
        rewards[first + view] += worth * chances[row * views + view];
      }
    }
  }
}
