package org.hificamsim.bench.plain;

import java.util.HashMap;
import java.util.Map;
import java.util.Random;

/** SARSA of thesis 7.4.4, rewarded with the change in the number of detected targets. */
final class Sarsa implements LevelPolicy {
  private static final double ALPHA = 0.1;
  private static final double GAMMA = 0.9;

  private record State(int level, int detected) {}

  private final int levels;
  private final double epsilon;
  private final Random random;
  private final Map<State, double[]> values = new HashMap<>();
  private State lastState;
  private int lastAction;

  Sarsa(int levels, double epsilon, Random random) {
    this.levels = levels;
    this.epsilon = epsilon;
    this.random = random;
  }

  @Override
  public int choose(int level, int detected) {
    State state = new State(level, detected);
    int action = EpsilonGreedy.explore(EpsilonGreedy.best(q(state)), levels, epsilon, random);
    if (lastState != null) {
      double reward = detected - lastState.detected();
      double[] before = q(lastState);
      before[lastAction] += ALPHA * (reward + GAMMA * q(state)[action] - before[lastAction]);
    }
    lastState = state;
    lastAction = action;
    return action;
  }

  private double[] q(State state) {
    return values.computeIfAbsent(state, unseen -> new double[levels]);
  }
}
