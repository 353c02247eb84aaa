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

  private final CameraTask<int[]> choosing = this::choose;
  private final CameraTask<int[]> updating = this::update;
  private final TemporalDifferenceSettings settings;
  private final EpsilonGreedyChoice choice;
  private ActionValues values;
  private int[] rows;
  private int[] credited;
  private int[] actions;
  private int[] counts;

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
   * cameras at a time.
   */
  protected int exploit(NetworkView network, int camera, int row) {
    return values.best(camera, row, network.levels(camera));
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
    network.divide(levels, choosing);
    network.divide(levels, updating);
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
