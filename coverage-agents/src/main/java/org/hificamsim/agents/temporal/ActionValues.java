package org.hificamsim.agents.temporal;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.hificamsim.agents.choice.TieBreak;
import org.hificamsim.agents.choice.Ties;
import org.hificamsim.core.InputException;
import org.hificamsim.core.policy.NetworkView;

/**
 * The Q tables of all cameras (Eq 7.6), and the best action of each state.
 *
 * <p>In a small network every table has all its states from the start; in a big one, where most
 * percepts never occur, a table grows to what its camera has met. States that it lacks have the
 * initial value.
 *
 * <p>Two things are for speed alone. The best actions have tables of their own, which stay in the
 * processor's cache when the values no longer fit: neighbours read nothing else (without these
 * tables a step of QB-SARSA takes 1.7 times as long, with 14 cameras and with 10,000). A bound on
 * the values of the other actions shows that most updates do not change the best one (without it
 * SARSA takes 1.2 times as long with 14 cameras).
 */
public final class ActionValues {
  /** Values up to which all tables together are made whole at once: 32 MiB. */
  private static final long MAX_WHOLE = 1 << 22;

  /** Values of one table: what an array can hold, with room to spare. */
  private static final long MAX_VALUES = 1 << 28;

  /** Percepts that a table of a big network has room for at first. */
  private static final int FIRST_PERCEPTS = 4;

  private final StateReading reading;
  private final TieBreak breaking;
  private final double initialValue;
  private final int percepts;
  private final int[] views;

  /** By camera; a row for each state: its actions' values, then a bound on those but the best. */
  private final double[][] values;

  /** By camera and state. */
  private final int[][] best;

  /**
   * @throws InputException when a camera's table would not fit into an array
   */
  ActionValues(NetworkView network, StateReading reading, Ties ties, double initialValue) {
    this.reading = reading;
    this.initialValue = initialValue;
    breaking = new TieBreak(ties, network);
    percepts = reading.percepts(network.targets());
    views = IntStream.range(0, network.cameras()).map(network::views).toArray();
    if (size(Arrays.stream(views).max().orElse(1)) > MAX_VALUES) {
      throw InputException.of(
          "a camera's table of action values needs more than %s entries for %s targets"
              + " and %s views. Maybe give the option state=none",
          MAX_VALUES, network.targets(), Arrays.stream(views).max().orElse(1));
    }
    boolean whole = Arrays.stream(views).mapToLong(this::size).sum() <= MAX_WHOLE;
    values = new double[views.length][0];
    best = new int[views.length][0];
    for (int camera = 0; camera < views.length; camera++) {
      resize(camera, whole ? percepts : Math.min(percepts, FIRST_PERCEPTS));
    }
  }

  private long size(int ofViews) {
    return (long) percepts * reading.statesPerPercept(ofViews) * width(ofViews);
  }

  private static int width(int ofViews) {
    return ofViews + 1;
  }

  /**
   * The number of a camera's state, from 0.
   *
   * @param view view in [0, views of the camera)
   * @param percept what it perceives, from 0: the number of targets detected, or {@link
   *     PicturePercept}'s
   */
  public int state(int camera, int view, int percept) {
    return reading.state(view, percept, views[camera]);
  }

  /** How many states a camera with most views has. */
  public long states() {
    return (long) percepts * reading.statesPerPercept(Arrays.stream(views).max().orElse(1));
  }

  /** The best action in a state. */
  public int best(int camera, int state) {
    int[] actions = best[camera];
    return state < actions.length ? actions[state] : breaking.best(camera);
  }

  /** The value of an action in a state. */
  public double value(int camera, int state, int action) {
    double[] table = values[camera];
    int row = state * width(views[camera]);
    return row < table.length ? table[row + action] : initialValue;
  }

  /** Sets the value of an action in a state. */
  public void set(int camera, int state, int action, double value) {
    grow(camera, state);
    double[] table = values[camera];
    int row = state * width(views[camera]);
    int bound = row + views[camera];
    int bestAction = best[camera][state];
    table[row + action] = value;
    if (action == bestAction ? value <= table[bound] : value >= table[row + bestAction]) {
      findBest(camera, state);
    } else if (action != bestAction) {
      table[bound] = Math.max(table[bound], value);
    }
  }

  private void findBest(int camera, int state) {
    double[] table = values[camera];
    int row = state * width(views[camera]);
    int end = row + views[camera];
    best[camera][state] = breaking.best(camera, table, row, views[camera]);
    table[end] = Double.NEGATIVE_INFINITY;
    for (int i = row; i < end; i++) {
      if (i != row + best[camera][state]) {
        table[end] = Math.max(table[end], table[i]);
      }
    }
  }

  /** Makes room for a state: where there is none, for at least twice as many. */
  private void grow(int camera, int state) {
    int states = best[camera].length;
    if (state >= states) {
      int each = reading.statesPerPercept(views[camera]);
      resize(camera, Math.min(percepts, Math.max(2 * states, state + each) / each));
    }
  }

  private void resize(int camera, int toPercepts) {
    int before = best[camera].length;
    int states = toPercepts * reading.statesPerPercept(views[camera]);
    best[camera] = Arrays.copyOf(best[camera], states);
    values[camera] = Arrays.copyOf(values[camera], states * width(views[camera]));
    Arrays.fill(values[camera], before * width(views[camera]), values[camera].length, initialValue);
    for (int state = before; state < states; state++) {
      findBest(camera, state);
    }
  }
}
