package org.hificamsim.agents.temporal;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.hificamsim.agents.choice.AbstractDistributedZoomPolicy;
import org.hificamsim.agents.choice.EpsilonGreedyChoice;
import org.hificamsim.agents.choice.Utility;
import org.hificamsim.core.policy.CameraTask;
import org.hificamsim.core.policy.NetworkView;

/**
 * Temporal-difference learning (thesis 7.4.4): each camera learns the values Q(s, a) of its
 * actions, which are its views, in its states.
 *
 * <p>An action is rewarded for the count that it led to; rewarding it for the change of the step
 * after would teach nothing. A camera that was offline in between gets no reward for what it
 * missed, and keeps what it has learned.
 */
public abstract class AbstractTemporalDifferenceZoomPolicy extends AbstractDistributedZoomPolicy {
  private static final int NONE = -1;

  private static final CameraTask<AbstractTemporalDifferenceZoomPolicy> MEASURING =
      (network, policy, from, to) -> policy.measure(network, from, to);

  private final TemporalDifferenceSettings settings;
  private final EpsilonGreedyChoice choice;
  private ActionValues q;
  private int[] lastState;
  private int[] lastAction;
  private double[] lastUtility;
  private Utility utility;
  private double[] utilities;

  protected AbstractTemporalDifferenceZoomPolicy(
      TemporalDifferenceSettings settings, EpsilonGreedyChoice choice) {
    this.settings = settings;
    this.choice = choice;
  }

  /** The value of the state that was reached (Eq 7.6), given the action chosen in it. */
  protected abstract double nextValue(int camera, int state, int action);

  /** The action that an online camera takes in a state unless it explores. */
  protected int greedy(int camera, int state) {
    return q.best(camera, state);
  }

  /** All cameras' action values; null before {@link #begin}. */
  public final ActionValues q() {
    return q;
  }

  @Override
  public void begin(NetworkView network, SplittableRandom random) {
    q = new ActionValues(network, settings);
    choice.begin(network, random);
    lastState = new int[network.cameras()];
    lastAction = new int[network.cameras()];
    lastUtility = new double[network.cameras()];
    utility = new Utility(settings.utility(), network.objective());
    utilities = new double[network.cameras()];
    Arrays.fill(lastState, NONE);
  }

  /** What a count does not tell is measured at once: targets move on before the next decision. */
  @Override
  public final void learn(NetworkView network) {
    if (!utility.counts()) {
      network.divide(this, MEASURING);
    }
  }

  private void measure(NetworkView network, int from, int to) {
    for (int camera = from; camera < to; camera++) {
      utilities[camera] = utility.of(network, camera);
    }
  }

  @Override
  protected final int choose(NetworkView network, int camera) {
    double gained = utility.counts() ? network.detected(camera) : utilities[camera];
    int state = q.state(network, camera);
    int action = choice.choose(camera, network.views(camera), greedy(camera, state));
    if (lastState[camera] != NONE) {
      learn(camera, gained, nextValue(camera, state, action));
    }
    lastState[camera] = state;
    lastAction[camera] = action;
    lastUtility[camera] = gained;
    return action;
  }

  /** Moves Q(s, a) of the decision before by alpha towards its reward and what followed. */
  private void learn(int camera, double gained, double nextValue) {
    int state = lastState[camera];
    int action = lastAction[camera];
    double value = q.value(camera, state, action);
    double reward =
        settings.lambda() * settings.reward().reward(lastUtility[camera], gained); // Eq 7.5
    double error = reward + settings.gamma() * nextValue - value;
    q.set(camera, state, action, value + settings.alpha() * error); // Eq 7.6
  }

  @Override
  protected final void skip(int camera) {
    lastState[camera] = NONE;
  }

  /** In blocks, for speed alone: {@link ActionValues#fetch}. */
  @Override
  protected final void chooseAll(NetworkView network, int[] views, int from, int to) {
    for (int first = from; first < to; first += ActionValues.BLOCK) {
      int end = Math.min(to, first + ActionValues.BLOCK);
      q.fetch(network, lastState, first, end);
      super.chooseAll(network, views, first, end);
    }
  }

  /**
   * The values of all actions in the camera's present state; how often each was learned is not
   * counted.
   */
  @Override
  public final String estimates(
      NetworkView network, int camera, double[] estimates, double[] counts) {
    int state = q.state(network, camera);
    for (int view = 0; view < network.views(camera); view++) {
      estimates[view] = q.value(camera, state, view);
      counts[view] = Double.NaN;
    }
    return "Q";
  }
}
