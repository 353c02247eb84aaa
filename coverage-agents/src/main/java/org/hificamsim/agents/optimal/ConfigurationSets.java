package org.hificamsim.agents.optimal;

import org.hificamsim.core.policy.OracleView;

/**
 * Fills the problem of a {@link org.hificamsim.solver.configuration.Solver} with what cameras can
 * detect.
 */
interface ConfigurationSets {
  /**
   * Fills the problem with the network as it is now. Its cameras are the online ones, numbered
   * again in their order.
   *
   * @return whether any target is present; if not, the problem is unchanged
   */
  boolean fill(OracleView network);

  /** The view to which a set of the problem belongs. */
  int viewOf(int set);
}
