package org.hificamsim.agents.optimal;

import org.hificamsim.core.policy.OracleView;

/**
 * What each camera could detect, as the problem of a {@link org.hificamsim.agents.search.Solver}.
 */
interface ConfigurationSets {
  /**
   * Fills the problem with the network as it is now; its cameras are the online ones.
   *
   * @return whether any target is present; if none is, the problem stays as it was
   */
  boolean fill(OracleView network);

  /** The view behind a set of the problem. */
  int viewOf(int set);
}
