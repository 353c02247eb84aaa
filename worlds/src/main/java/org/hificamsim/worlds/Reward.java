package org.hificamsim.worlds;

import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.NetworkView;

/** Computes the rewards of the cameras for a step. Each world has its own instance. */
@FunctionalInterface
public interface Reward {
  /**
   * Computes the rewards for the last observation.
   *
   * @param out receives the reward of each camera
   */
  void pay(NetworkView network, StepCoverage coverage, float[] out);

  /** Called when an episode begins. */
  default void begin() {}
}
