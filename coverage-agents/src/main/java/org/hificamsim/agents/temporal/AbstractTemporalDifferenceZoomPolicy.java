package org.hificamsim.agents.temporal;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.hificamsim.agents.choice.EpsilonGreedyChoice;
import org.hificamsim.core.policy.CameraTask;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;

/**
 * Temporal-difference learning (section 7.4.4, Eqs 7.5 and 7.6): state, choice, reward and update,
 * common to its variants.
 *
 * <p>At each decision every online camera first chooses its next level from the values as they
 * stand; then all update the value of the level chosen the time before. Its reward is the one for
 * the count that it led to; crediting an action with the change of the step after would teach
 * nothing. A camera that was offline in between starts afresh with what it had learned. A variant
 * says what the state that was reached is worth ({@link #successor}), and may say what exploiting
 * means ({@link #exploit}).
 */
public abstract class AbstractTemporalDifferenceZoomPolicy implements ZoomPolicy {
  private static final int NONE = -1;

  /** Cameras whose values are fetched at a time: few enough to stay in the first cache. */
  private static final int BLOCK = 32;

  /** Cameras whose values are in the cache anyway. */
  private static final int FEW = 500;

  private final CameraTask<int[]> choosing =
      (network, levels, from, to) -> inBlocks(network, levels, from, to, true, false);
  private final CameraTask<int[]> updating =
      (network, levels, from, to) -> inBlocks(network, levels, from, to, false, true);
  private final CameraTask<int[]> choosingAndUpdating =
      (network, levels, from, to) -> inBlocks(network, levels, from, to, true, true);
  private final TemporalDifferenceSettings settings;
  private final EpsilonGreedyChoice choice;
  private ActionValues values;
  private int[] rows;
  private int[] credited;
  private int[] actions;
  private int[] counts;

  @SuppressWarnings("UnusedVariable") // written lest the reads that it sums up are left out
  private double fetched;

  protected AbstractTemporalDifferenceZoomPolicy(
      TemporalDifferenceSettings settings, EpsilonGreedyChoice choice) {
    this.settings = settings;
    this.choice = choice;
  }

  /**
   * The value of the state that was reached, which the discount factor multiplies in Eq 7.6.
   *
   * @param camera whose state it is
   * @param row row of that state
   * @param levels number of actions in it
   * @param action the action chosen in it
   */
  protected abstract double successor(
      ActionValues table, int camera, int row, int levels, int action);

  /**
   * The level that the camera takes when it does not explore: its best known one. Asked for several
   * cameras at a time. Where it looks at other cameras' values, {@link #asksOthers} must say so.
   */
  protected int exploit(NetworkView network, int camera, int row) {
    return values.best(camera, row, network.levels(camera));
  }

  /**
   * Whether {@link #exploit} looks at other cameras' values: then all choose before any updates.
   */
  protected boolean asksOthers() {
    return false;
  }

  /** All cameras' tables; null before {@link #begin}. */
  public final ActionValues values() {
    return values;
  }

  @Override
  public void begin(NetworkView network, SplittableRandom random) {
    values = new ActionValues(network, settings);
    choice.begin(network, random);
    rows = new int[network.cameras()];
    credited = new int[network.cameras()];
    actions = new int[network.cameras()];
    counts = new int[network.cameras()];
    Arrays.fill(credited, NONE);
  }

  @Override
  public void decide(NetworkView network, int[] levels) {
    if (asksOthers()) {
      network.divide(levels, choosing);
      network.divide(levels, updating);
    } else {
      network.divide(levels, choosingAndUpdating);
    }
  }

  /**
   * In a big network what a block of cameras needs is read beforehand, with nothing in between that
   * waits for it: so it comes from memory at once, where camera by camera each would wait.
   */
  private void inBlocks(
      NetworkView network, int[] levels, int from, int to, boolean choosing, boolean updating) {
    for (int first = from; first < to; first += BLOCK) {
      int end = Math.min(to, first + BLOCK);
      if (credited.length > FEW) {
        fetch(network, first, end, choosing);
      }
      if (choosing) {
        choose(network, levels, first, end);
      }
      if (updating) {
        update(network, levels, first, end);
      }
    }
  }

  private void fetch(NetworkView network, int from, int to, boolean choosing) {
    double sum = 0;
    for (int camera = from; camera < to; camera++) {
      sum += values.fetch(camera, values.row(network, camera));
      sum += values.fetch(camera, Math.max(0, credited[camera]));
      sum += choosing ? fetchOthers(network, camera) : 0;
    }
    fetched = sum;
  }

  /** Reads what {@link #exploit} is to read of other cameras; what it returns means nothing. */
  protected double fetchOthers(NetworkView network, int camera) {
    return 0;
  }

  private void choose(NetworkView network, int[] levels, int from, int to) {
    for (int camera = from; camera < to; camera++) {
      if (network.online(camera)) {
        rows[camera] = values.row(network, camera);
        int best = exploit(network, camera, rows[camera]);
        levels[camera] = choice.choose(camera, network.levels(camera), best);
      }
    }
  }

  private void update(NetworkView network, int[] levels, int from, int to) {
    for (int camera = from; camera < to; camera++) {
      if (network.online(camera)) {
        update(network, camera, levels[camera]);
      } else {
        credited[camera] = NONE;
      }
    }
  }

  /**
   * The values of all actions in the camera's present state; how often each was learned is not
   * counted.
   */
  @Override
  public final String estimates(
      NetworkView network, int camera, double[] estimates, double[] counts) {
    int row = values.row(network, camera);
    for (int level = 0; level < network.levels(camera); level++) {
      estimates[level] = values.value(camera, row, level);
      counts[level] = Double.NaN;
    }
    return "Q";
  }

  private void update(NetworkView network, int camera, int action) {
    int row = rows[camera];
    int detected = network.detected(camera);
    values.grow(camera, row);
    if (credited[camera] != NONE) {
      double reward = settings.lambda() * settings.reward().reward(counts[camera], detected);
      double reached = successor(values, camera, row, network.levels(camera), action);
      double target = reward + settings.gamma() * reached;
      values.learn(camera, credited[camera], actions[camera], settings.alpha(), target);
    }
    credited[camera] = row;
    actions[camera] = action;
    counts[camera] = detected;
  }
}
