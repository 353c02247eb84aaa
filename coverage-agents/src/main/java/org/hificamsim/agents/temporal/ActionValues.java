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
 * <p>In a small network every table has all its states from the beginning. In a big one, where most
 * percepts never occur, a table grows with the percepts that its camera meets; states beyond it
 * have the initial value.
 *
 * <p>Two details serve only speed. The best actions have tables of their own, which stay in the
 * processor's cache when the values no longer fit: neighbours read nothing else (without these
 * tables a step of QB-SARSA takes 1.7 times as long, with 14 cameras and with 10,000). A bound on
 * the values of the other actions shows that most updates do not change the best one (without it
 * SARSA takes 1.2 times as long with 14 cameras).
 */
public final class ActionValues {
  /** The number of values up to which all tables have all their states at once: 32 MiB. */
  private static final long MAX_COMPLETE_VALUES = 1 << 22;

  /** The greatest number of values of one table: 2 GiB, within the limit of an array. */
  private static final long MAX_TABLE_VALUES = 1 << 28;

  /** The number of percepts of a table of a big network at the beginning. */
  private static final int FIRST_PERCEPTS = 4;

  private final StateReading reading;
  private final TieBreak tieBreak;
  private final double initialValue;
  private final int percepts;
  private final int[] viewCounts;

  /**
   * The rows of states by camera: the values of the actions, then an upper bound on those of all
   * actions except the best one.
   */
  private final double[][] values;

  /** The action with the greatest value, by camera and state. */
  private final int[][] bestActions;

  /**
   * @throws InputException if a camera's table does not fit into an array
   */
  ActionValues(NetworkView network, StateReading reading, Ties ties, double initialValue) {
    this.reading = reading;
    this.initialValue = initialValue;
    tieBreak = new TieBreak(ties, network);
    percepts = reading.percepts(network.targets());
    viewCounts = IntStream.range(0, network.cameras()).map(network::views).toArray();
    if (size(Arrays.stream(viewCounts).max().orElse(1)) > MAX_TABLE_VALUES) {
      throw InputException.of(
          "a camera's table of action values needs more than %s entries for %s targets"
              + " and %s views. Maybe give the option state=none",
          MAX_TABLE_VALUES, network.targets(), Arrays.stream(viewCounts).max().orElse(1));
    }
    boolean complete = Arrays.stream(viewCounts).mapToLong(this::size).sum() <= MAX_COMPLETE_VALUES;
    values = new double[viewCounts.length][0];
    bestActions = new int[viewCounts.length][0];
    for (int camera = 0; camera < viewCounts.length; camera++) {
      resize(camera, complete ? percepts : Math.min(percepts, FIRST_PERCEPTS));
    }
  }

  private long size(int views) {
    return (long) percepts * reading.statesPerPercept(views) * rowLength(views);
  }

  private static int rowLength(int views) {
    return views + 1;
  }

  /**
   * The number of a camera's state, from 0.
   *
   * @param view view in [0, views of the camera)
   * @param percept from 0: the number of targets detected, or that of {@link PicturePercept}
   */
  public int state(int camera, int view, int percept) {
    return reading.state(view, percept, viewCounts[camera]);
  }

  /** The number of states of a camera with most views. */
  public long states() {
    return (long) percepts * reading.statesPerPercept(Arrays.stream(viewCounts).max().orElse(1));
  }

  /** The best action in a state. */
  public int best(int camera, int state) {
    int[] actions = bestActions[camera];
    return state < actions.length ? actions[state] : tieBreak.best(camera);
  }

  /** The value of an action in a state. */
  public double value(int camera, int state, int action) {
    double[] table = values[camera];
    int row = state * rowLength(viewCounts[camera]);
    return row < table.length ? table[row + action] : initialValue;
  }

  /** Sets the value of an action in a state. */
  public void set(int camera, int state, int action, double value) {
    ensureState(camera, state);
    double[] table = values[camera];
    int row = state * rowLength(viewCounts[camera]);
    int bound = row + viewCounts[camera];
    int bestAction = bestActions[camera][state];
    table[row + action] = value;
    if (action == bestAction ? value <= table[bound] : value >= table[row + bestAction]) {
      findBest(camera, state);
    } else if (action != bestAction) {
      table[bound] = Math.max(table[bound], value);
    }
  }

  private void findBest(int camera, int state) {
    double[] table = values[camera];
    int row = state * rowLength(viewCounts[camera]);
    int end = row + viewCounts[camera];
    bestActions[camera][state] = tieBreak.best(camera, table, row, viewCounts[camera]);
    table[end] = Double.NEGATIVE_INFINITY;
    for (int i = row; i < end; i++) {
      if (i != row + bestActions[camera][state]) {
        table[end] = Math.max(table[end], table[i]);
      }
    }
  }

  /** Extends a table to a state that is beyond it, at least to twice its size. */
  private void ensureState(int camera, int state) {
    int states = bestActions[camera].length;
    if (state >= states) {
      int statesPerPercept = reading.statesPerPercept(viewCounts[camera]);
      int needed = Math.max(2 * states, state + statesPerPercept) / statesPerPercept;
      resize(camera, Math.min(percepts, needed));
    }
  }

  private void resize(int camera, int newPercepts) {
    int before = bestActions[camera].length;
    int states = newPercepts * reading.statesPerPercept(viewCounts[camera]);
    bestActions[camera] = Arrays.copyOf(bestActions[camera], states);
    values[camera] = Arrays.copyOf(values[camera], states * rowLength(viewCounts[camera]));
    Arrays.fill(
        values[camera],
        before * rowLength(viewCounts[camera]),
        values[camera].length,
        initialValue);
    for (int state = before; state < states; state++) {
      findBest(camera, state);
    }
  }
}
