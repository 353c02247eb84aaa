package org.hificamsim.agents.temporal;

import java.util.Arrays;
import org.hificamsim.agents.choice.Ties;
import org.hificamsim.core.InputException;
import org.hificamsim.core.policy.NetworkView;

/**
 * The Q tables of all cameras (Eq 7.6), each in an array of its own: the entry for an action stands
 * at the row of the camera's state plus the action's level. Two more entries of a row are its best
 * action, so that asking for it, which neighbours do most often, is one look; and a value that none
 * of the other actions exceeds, so that most updates tell at a glance that the best one stays best.
 *
 * <p>Rows go by the number of targets detected, the fewest first. In a small network every table
 * has all its rows from the start; in a big one, where most counts never occur, a table grows to
 * what its camera has met. Rows it lacks hold the initial value. Cameras may be worked on side by
 * side as long as each table's {@link #grow} and {@link #set} have their camera for themselves.
 */
public final class ActionValues {
  /** Entries up to which all tables together are made whole at once: 32 MiB. */
  private static final long FEW_ENTRIES = 1 << 22;

  /** Entries of one table: what an array can hold, with room to spare. */
  private static final long MOST_ENTRIES = 1 << 28;

  /** Entries of a row beside its actions' values. */
  private static final int EXTRA = 2;

  /** Counts that a table of a big network has rows for at first. */
  private static final int FIRST_COUNTS = 4;

  private final StateReading reading;
  private final Ties ties;
  private final int mostCounts;
  private final double initialValue;
  private final int[] levels;
  private final double[][] tables;
  private final double[] unmet;

  /**
   * @throws InputException when a camera's table would not fit into an array
   */
  ActionValues(NetworkView network, TemporalDifferenceSettings settings) {
    reading = settings.state();
    ties = settings.ties();
    initialValue = settings.initialValue();
    mostCounts = reading.counts(network.targets());
    levels = new int[network.cameras()];
    Arrays.setAll(levels, network::levels);
    int mostLevels = Arrays.stream(levels).max().orElse(1);
    if (size(mostLevels, mostCounts) > MOST_ENTRIES) {
      throw new InputException(
          "a camera's table of action values needs more than "
              + MOST_ENTRIES
              + " entries for "
              + network.targets()
              + " targets. Maybe give the option state=none");
    }
    long entries = Arrays.stream(levels).mapToLong(count -> size(count, mostCounts)).sum();
    int counts = entries <= FEW_ENTRIES ? mostCounts : Math.min(mostCounts, FIRST_COUNTS);
    tables = new double[levels.length][];
    for (int camera = 0; camera < levels.length; camera++) {
      tables[camera] = new double[(int) size(levels[camera], counts)];
      fill(camera, 0);
    }
    unmet = new double[mostLevels];
    Arrays.fill(unmet, initialValue);
  }

  /** Gives a table its initial values from some row on. */
  private void fill(int camera, int fromRow) {
    double[] table = tables[camera];
    Arrays.fill(table, fromRow, table.length, initialValue);
    for (int row = fromRow; row < table.length; row += levels[camera] + EXTRA) {
      findBest(camera, row);
    }
  }

  private void findBest(int camera, int row) {
    double[] table = tables[camera];
    int end = row + levels[camera];
    int best = ties.best(table, row, levels[camera]);
    double others = Double.NEGATIVE_INFINITY;
    for (int i = row; i < end; i++) {
      others = i == row + best ? others : Math.max(others, table[i]);
    }
    table[end] = best;
    table[end + 1] = others;
  }

  private long size(int ofLevels, int counts) {
    return (long) counts * reading.statesPerCount(ofLevels) * (ofLevels + EXTRA);
  }

  /** The row of a camera's present state. */
  int row(NetworkView network, int camera) {
    return row(camera, network.level(camera), network.detected(camera));
  }

  /**
   * Where a camera's table keeps its values for a state.
   *
   * @param level level in [0, levels of the camera)
   * @param detected number of targets in [0, all targets]
   */
  public int row(int camera, int level, int detected) {
    return reading.state(level, detected, levels[camera]) * (levels[camera] + EXTRA);
  }

  /** Whether two cameras have equally many levels, and so the same row for the same state. */
  public boolean alike(int camera, int other) {
    return levels[camera] == levels[other];
  }

  /** Whether the camera has levels enough to ever be at this one. */
  public boolean knows(int camera, int level) {
    return reading != StateReading.LEVEL_COUNT || level < levels[camera];
  }

  /** Reads both ends of a row, so that it comes into the cache; what it returns means nothing. */
  public double fetch(int camera, int row) {
    double[] table = tables[camera];
    return row < table.length ? table[row] + table[row + levels[camera] + 1] : 0;
  }

  /** The best action of a row's first {@code actions} levels. */
  public int best(int camera, int row, int actions) {
    double[] table = tables[camera];
    if (row >= table.length) {
      return ties.best(unmet, 0, actions);
    }
    return actions == levels[camera] ? (int) table[row + actions] : ties.best(table, row, actions);
  }

  /** What a camera's table holds best for another camera's state, of the levels that both have. */
  public int answer(int camera, int level, int detected, int levelsOfOther) {
    return best(camera, row(camera, level, detected), Math.min(levelsOfOther, levels[camera]));
  }

  /** The value of an action in a row. */
  public double value(int camera, int row, int action) {
    double[] table = tables[camera];
    return row < table.length ? table[row + action] : initialValue;
  }

  /** Sets the value of an action in a row. */
  public void set(int camera, int row, int action, double value) {
    grow(camera, row);
    tables[camera][row + action] = value;
    findBest(camera, row);
  }

  /** Makes sure that a camera's table has a row: it at least doubles where it has not. */
  void grow(int camera, int row) {
    int length = tables[camera].length;
    if (row >= length) {
      long block = size(levels[camera], 1);
      long wanted = Math.max(2L * length, (row / block + 1) * block);
      long most = size(levels[camera], mostCounts);
      tables[camera] = Arrays.copyOf(tables[camera], (int) Math.min(wanted, most));
      fill(camera, length);
    }
  }

  /** Moves the entry by {@code alpha} of its distance to {@code target} (Eq 7.6). */
  void learn(int camera, int row, int action, double alpha, double target) {
    double[] table = tables[camera];
    double before = table[row + action];
    double after = before + alpha * (target - before);
    table[row + action] = after;
    int end = row + levels[camera];
    int best = (int) table[end];
    boolean stays = action == best ? after > table[end + 1] : after < table[row + best];
    if (!stays) {
      findBest(camera, row);
    } else if (action != best) {
      table[end + 1] = Math.max(table[end + 1], after);
    }
  }
}
