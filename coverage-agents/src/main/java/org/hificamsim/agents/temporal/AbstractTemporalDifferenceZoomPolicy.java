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
 *
 * <p>Where moves take time, an action lasts until the camera has arrived, n steps after it was
 * chosen. It earns the rewards r_1 to r_n of these, and what follows is discounted by as many
 * steps: Q(s, a) moves towards {@code r_1 + gamma r_2 + ... + gamma^(n-1) r_n + gamma^n Q(s', a')},
 * the update of a semi-Markov decision process (Bradtke and Duff 1994).
 */
public abstract class AbstractTemporalDifferenceZoomPolicy extends AbstractDistributedZoomPolicy {
  private static final int NONE = -1;

  private static final CameraTask<AbstractTemporalDifferenceZoomPolicy> MEASURING =
      (network, policy, from, to) -> policy.measure(network, from, to);

  private final TemporalDifferenceSettings settings;
  private final EpsilonGreedyChoice choice;
  private ActionValues q;
  private Percepts percepts;
  private int[] lastState;
  private int[] lastAction;
  private double[] lastUtility;
  private Utility utility;
  private double[] utilities;
  private double[] earned; // on the way
  private double[] discount; // of what comes next

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
    percepts = new Percepts(network, settings.state());
    choice.begin(network, random);
    lastState = new int[network.cameras()];
    lastAction = new int[network.cameras()];
    lastUtility = new double[network.cameras()];
    utility = new Utility(settings.utility(), network.objective());
    utilities = new double[network.cameras()];
    Arrays.fill(lastState, NONE);
    earned = new double[network.cameras()];
    discount = new double[network.cameras()];
  }

  /** What all cameras do when they have looked, and before any decides. */
  protected void prepare(NetworkView network) {}

  @Override
  public final void decide(NetworkView network, int[] views) {
    percepts.update(network);
    prepare(network);
    super.decide(network, views);
  }

  /** What the camera perceived before the decision that is under way, from 0. */
  protected final int percept(NetworkView network, int camera) {
    return percepts.of(network, camera);
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
    double gained = gained(network, camera);
    int state = q.state(camera, network.view(camera), percept(network, camera));
    int action = choice.choose(camera, network.views(camera), greedy(camera, state));
    if (lastState[camera] != NONE) {
      learn(camera, gained, nextValue(camera, state, action));
    }
    lastState[camera] = state;
    lastAction[camera] = action;
    lastUtility[camera] = gained;
    earned[camera] = 0;
    discount[camera] = 1;
    return action;
  }

  @Override
  protected final int travel(NetworkView network, int camera) {
    double gained = gained(network, camera);
    earned[camera] += discount[camera] * reward(camera, gained);
    discount[camera] *= settings.gamma();
    lastUtility[camera] = gained;
    return network.view(camera);
  }

  private double gained(NetworkView network, int camera) {
    return utility.counts() ? network.detected(camera) : utilities[camera];
  }

  /** Moves Q(s, a) of the decision before by alpha towards its reward and what followed. */
  private void learn(int camera, double gained, double nextValue) {
    int state = lastState[camera];
    int action = lastAction[camera];
    double value = q.value(camera, state, action);
    double arrived = reward(camera, gained) + settings.gamma() * nextValue;
    double error = earned[camera] + discount[camera] * arrived - value;
    q.set(camera, state, action, value + settings.alpha() * error); // Eq 7.6
  }

  private double reward(int camera, double gained) {
    return settings.lambda() * settings.reward().reward(lastUtility[camera], gained); // Eq 7.5
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
      q.fetch(network, percepts, lastState, first, end);
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
    int state = q.state(camera, network.view(camera), percepts.now(network, camera));
    for (int view = 0; view < network.views(camera); view++) {
      estimates[view] = q.value(camera, state, view);
      counts[view] = Double.NaN;
    }
    return "Q";
  }
}
