package org.hificamsim.network.study;

/** The kinds of networks that a study compares. */
public enum NetworkKind {
  /** All cameras have one strategy. */
  HOMOGENEOUS,
  /** Cameras have strategies of their own. */
  HETEROGENEOUS,
  /** Cameras choose by a bandit. */
  BANDIT
}
