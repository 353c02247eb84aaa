package org.hificamsim.agents.temporal;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.hificamsim.agents.choice.AbstractDistributedZoomPolicy;
import org.hificamsim.agents.choice.EpsilonGreedyChoice;
import org.hificamsim.agents.choice.Ties;
import org.hificamsim.agents.choice.Utility;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.registry.Options;

/**
 * Temporal-difference learning (thesis 7.4.4): each camera learns the values Q(s, a) of its
 * actions, which are its views, in its states.
 *
 * <p>An action is rewarded for the count to which it led. A camera that was offline gets no reward
 * for what it missed, and keeps what it has learned.
 *
 * <p>If moves take time, an action lasts until the camera has arrived, n steps after it was chosen.
 * It earns the rewards r_1 to r_n of these steps, and all later ones are discounted by n steps:
 * Q(s, a) moves towards {@code r_1 + gamma r_2 + ... + gamma^(n-1) r_n + gamma^n Q(s', a')}, the
 * update of a semi-Markov decision process (Bradtke and Duff 1994).
 */
public class TemporalDifferenceZoomPolicy extends AbstractDistributedZoomPolicy {
  private static final int NONE = -1;
  private static final double MAX_PARAMETER = 1e6;

  private final String name;
  private final boolean onPolicy;
  private final StateReading states;
  private final RewardReading rewards;
  private final Utility.Reading utilityReading;
  private final double alpha;
  private final double gamma;
  private final double lambda;
  private final double initialValue;
  private final Ties ties;
  private final EpsilonGreedyChoice choice;
  private NetworkView network;
  private ActionValues q;

  /** The percepts from pictures; null if a percept is the number of detected targets. */
  private PicturePercept picture;

  private int[] lastState;
  private int[] lastAction;
  private double[] lastUtility;
  private Utility utility;
  private double[] utilities;

  /** The discounted rewards of each camera's last action before it arrived. */
  private double[] earlierRewards;

  /** The discount of the next reward of each camera's last action. */
  private double[] nextDiscount;

  /**
   * Reads the parameters of Eqs 7.5 and 7.6, the readings that the thesis leaves open, and how to
   * explore. The defaults come closest to Table 8.1; the discount is not published.
   *
   * @param onPolicy whether the next value is that of the chosen action, as in SARSA, and not that
   *     of the best one, as in Q-learning
   */
  protected TemporalDifferenceZoomPolicy(String name, boolean onPolicy, Options options) {
    this.name = name;
    this.onPolicy = onPolicy;
    states =
        options.choice(
            "state",
            StateReading.LEVEL_COUNT,
            "what a camera knows: level-count, count, none, picture, view-picture, picture-depth,"
                + " view-picture-depth");
    rewards =
        options.choice(
            "reward", RewardReading.COUNT_CHANGE, "Eq 7.5 as: count-change, sign, literal");
    utilityReading = Utility.from(options);
    alpha = options.number("alpha", 0.1, 0, 1, "learning rate");
    gamma = options.number("gamma", 0.9, 0, 1, "discount factor");
    lambda = options.number("lambda", 1, 0, MAX_PARAMETER, "factor on every reward");
    initialValue =
        options.number("q0", 0, -MAX_PARAMETER, MAX_PARAMETER, "value of every action at first");
    ties = Ties.from(options);
    choice = new EpsilonGreedyChoice(options);
  }

  /** Creates SARSA, the on-policy variant (thesis 7.4.4, Eq 7.6). */
  public static TemporalDifferenceZoomPolicy sarsa(Options options) {
    return new TemporalDifferenceZoomPolicy("sarsa", true, options);
  }

  /** Creates Q-learning, the off-policy variant with which thesis 7.4.4 compares SARSA. */
  public static TemporalDifferenceZoomPolicy qLearning(Options options) {
    return new TemporalDifferenceZoomPolicy("q-learning", false, options);
  }

  @Override
  public final String name() {
    return name;
  }

  /** Returns Q(s', a') of the action chosen in the new state; for Q-learning max Q(s', a'). */
  private double nextValue(int camera, int state, int action) {
    return q.value(camera, state, onPolicy ? action : q.best(camera, state));
  }

  /** Returns the action that an online camera takes in a state unless it explores. */
  protected int greedy(int camera, int state) {
    return q.best(camera, state);
  }

  /** The action values of all cameras; null before {@link #begin}. */
  public final ActionValues q() {
    return q;
  }

  @Override
  public void begin(NetworkView newNetwork, SplittableRandom random) {
    network = newNetwork;
    q = new ActionValues(network, states, ties, initialValue);
    picture =
        states.parts() == 0
            ? null
            : new PicturePercept(network.cameras(), states.parts() > PicturePercept.THIRDS);
    choice.begin(network, random);
    lastState = new int[network.cameras()];
    lastAction = new int[network.cameras()];
    lastUtility = new double[network.cameras()];
    utility = new Utility(utilityReading, network.objective());
    utilities = new double[network.cameras()];
    Arrays.fill(lastState, NONE);
    earlierRewards = new double[network.cameras()];
    nextDiscount = new double[network.cameras()];
  }

  /** Called after all cameras have looked, and before any decides. */
  protected void prepare(NetworkView network) {}

  @Override
  public final void decide(NetworkView network, int[] views) {
    if (picture != null) {
      picture.update(network);
    }
    prepare(network);
    super.decide(network, views);
  }

  /** The camera's percept before the present decision, from 0. */
  protected final int percept(NetworkView network, int camera) {
    return picture == null ? network.detected(camera) : picture.lastPercept(camera);
  }

  /**
   * Computes utilities other than counts at once, because targets move before the next decision.
   */
  @Override
  public final void learn(NetworkView network) {
    if (!utility.isCount()) {
      for (int camera = 0; camera < network.cameras(); camera++) {
        utilities[camera] = utility.compute(network, camera);
      }
    }
  }

  @Override
  protected final int choose(NetworkView network, int camera) {
    double newUtility = newUtility(network, camera);
    int state = q.state(camera, network.view(camera), percept(network, camera));
    int action = choice.choose(camera, network.views(camera), greedy(camera, state));
    if (lastState[camera] != NONE) {
      learn(camera, newUtility, nextValue(camera, state, action));
    }
    lastState[camera] = state;
    lastAction[camera] = action;
    lastUtility[camera] = newUtility;
    earlierRewards[camera] = 0;
    nextDiscount[camera] = 1;
    return action;
  }

  @Override
  protected final int travel(NetworkView network, int camera) {
    double newUtility = newUtility(network, camera);
    earlierRewards[camera] += nextDiscount[camera] * reward(camera, newUtility);
    nextDiscount[camera] *= gamma;
    lastUtility[camera] = newUtility;
    return network.view(camera);
  }

  private double newUtility(NetworkView network, int camera) {
    return utility.isCount() ? network.detected(camera) : utilities[camera];
  }

  /**
   * Moves Q(s, a) of the last decision by alpha towards its rewards and the next value (Eq 7.6).
   */
  private void learn(int camera, double newUtility, double nextValue) {
    int state = lastState[camera];
    int action = lastAction[camera];
    double value = q.value(camera, state, action);
    double onArrival = reward(camera, newUtility) + gamma * nextValue;
    double error = earlierRewards[camera] + nextDiscount[camera] * onArrival - value;
    q.set(camera, state, action, value + alpha * error);
  }

  /** The reward of Eq 7.5. */
  private double reward(int camera, double newUtility) {
    return lambda * rewards.reward(lastUtility[camera], newUtility);
  }

  @Override
  protected final void skip(int camera) {
    lastState[camera] = NONE;
  }

  /**
   * Reports the values of all actions in the camera's present state. The number of updates of each
   * is not counted.
   */
  @Override
  public final String estimates(int camera, double[] estimates, double[] counts) {
    int percept =
        picture == null ? network.detected(camera) : picture.presentPercept(network, camera);
    int state = q.state(camera, network.view(camera), percept);
    for (int view = 0; view < network.views(camera); view++) {
      estimates[view] = q.value(camera, state, view);
      counts[view] = Double.NaN;
    }
    return "Q";
  }
}
