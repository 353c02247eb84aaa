package org.hificamsim.agents.temporal;

import org.hificamsim.core.registry.Options;

/** SARSA, the on-policy variant (thesis 7.4.4, Eq 7.6). */
public class SarsaZoomPolicy extends AbstractTemporalDifferenceZoomPolicy {
  public SarsaZoomPolicy(Options options) {
    super(options);
  }

  @Override
  public String name() {
    return "sarsa";
  }

  /** Q(s', a'): the value of the action chosen there. */
  @Override
  protected final double nextValue(int camera, int state, int action) {
    return q().value(camera, state, action);
  }
}
