package org.hificamsim.agents.temporal;

import org.hificamsim.core.registry.Options;

/** Q-learning, the off-policy variant that thesis 7.4.4 sets SARSA against. */
public final class QLearningZoomPolicy extends AbstractTemporalDifferenceZoomPolicy {
  public QLearningZoomPolicy(Options options) {
    super(options);
  }

  @Override
  public String name() {
    return "q-learning";
  }

  /** max Q(s', a): the value of the best action there, whichever is chosen. */
  @Override
  protected double nextValue(int camera, int state, int action) {
    return q().value(camera, state, q().best(camera, state));
  }
}
