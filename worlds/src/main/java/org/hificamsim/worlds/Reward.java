package org.hificamsim.worlds;

import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.NetworkView;

/** What cameras are paid for a step. One instance for one world. */
@FunctionalInterface
public interface Reward {
  /**
   * Pays for the observation just made.
   *
   * @param out one entry for each camera; receives its pay
   */
  void pay(NetworkView network, StepCoverage coverage, float[] out);

  /** An episode begins. */
  default void begin() {}
}
