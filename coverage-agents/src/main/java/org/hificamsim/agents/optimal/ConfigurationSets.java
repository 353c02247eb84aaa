package org.hificamsim.agents.optimal;

import org.hificamsim.agents.search.CoverageProblem;
import org.hificamsim.core.policy.NetworkView;

/**
 * What each camera could detect, as a coverage problem of which {@link ConfigurationSearch} finds
 * the best.
 */
interface ConfigurationSets {
  /** The problem that {@link #fill} fills. */
  CoverageProblem problem();

  /**
   * Fills the problem with the network as it is now; its cameras are the online ones.
   *
   * @return whether any target is present; if none is, the problem stays as it was
   */
  boolean fill(NetworkView network);

  /** The view behind a set of the problem. */
  int viewOf(int set);
}
