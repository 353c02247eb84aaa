package org.hificamsim.agents.temporal;

import java.util.Arrays;
import org.hificamsim.agents.choice.Ties;
import org.hificamsim.core.InputException;
import org.hificamsim.core.policy.NetworkView;

/**
 * The Q tables of all cameras (Eq 7.6) in one flat array: the entry for an action stands at the row
 * of the camera's state plus the action's level.
 */
public final class ActionValues {
  private static final long MOST_ENTRIES = 1 << 28;

  private final StateReading reading;
  private final Ties ties;
  private final int targets;
  private final int[] levels;
  private final int[] offsets;
  private final double[] values;

  /**
   * @throws InputException when the tables would not fit into an array
   */
  ActionValues(NetworkView network, TemporalDifferenceSettings settings) {
    reading = settings.state();
    ties = settings.ties();
    targets = network.targets();
    levels = new int[network.cameras()];
    offsets = new int[network.cameras()];
    long size = 0;
    for (int camera = 0; camera < levels.length; camera++) {
      levels[camera] = network.levels(camera);
      offsets[camera] = (int) size;
      size += reading.states(levels[camera], targets) * levels[camera];
      if (size > MOST_ENTRIES) {
        throw new InputException(
            "the cameras' tables of action values need more than "
                + MOST_ENTRIES
                + " entries for "
                + targets
                + " targets. Maybe give the option state=none");
      }
    }
    values = new double[(int) size];
    Arrays.fill(values, settings.initialValue());
  }

  /** The row of a camera's present state. */
  int row(NetworkView network, int camera) {
    return row(camera, network.level(camera), network.detected(camera));
  }

  /**
   * Where a camera keeps its values for a state.
   *
   * @param level level in [0, levels of the camera)
   * @param detected number of targets in [0, all targets]
   */
  public int row(int camera, int level, int detected) {
    return offsets[camera] + reading.state(level, detected, targets) * levels[camera];
  }

  /** Whether the camera has levels enough to ever be at this one. */
  public boolean knows(int camera, int level) {
    return reading != StateReading.LEVEL_COUNT || level < levels[camera];
  }

  /** The best action of a row's first {@code actions} levels. */
  public int best(int row, int actions) {
    return ties.best(values, row, actions);
  }

  public double value(int row, int action) {
    return values[row + action];
  }

  /** Sets the value of an action in a row. */
  public void set(int row, int action, double value) {
    values[row + action] = value;
  }

  /** Moves the entry by {@code alpha} of its distance to {@code target} (Eq 7.6). */
  void learn(int entry, double alpha, double target) {
    values[entry] += alpha * (target - values[entry]);
  }
}
