package org.hificamsim.agents.temporal;

import org.hificamsim.agents.choice.EpsilonGreedyChoice;
import org.hificamsim.core.registry.Options;

/** SARSA, the on-policy variant (section 7.4.4, Eq 7.6). */
public class SarsaZoomPolicy extends AbstractTemporalDifferenceZoomPolicy {
  public static final String NAME = "sarsa";

  public SarsaZoomPolicy(TemporalDifferenceSettings settings, EpsilonGreedyChoice choice) {
    super(settings, choice);
  }

  /** The policy with its options. */
  public static SarsaZoomPolicy from(Options options) {
    return new SarsaZoomPolicy(
        TemporalDifferenceSettings.from(options), EpsilonGreedyChoice.from(options));
  }

  @Override
  public String name() {
    return NAME;
  }

  /** The value of the action chosen there: Q(s_(t+1), a_(t+1)). */
  @Override
  protected final double successor(
      ActionValues table, int camera, int row, int levels, int action) {
    return table.value(camera, row, action);
  }
}
