package org.hificamsim.network.study;

import org.hificamsim.runs.RunPlan;

/**
 * One network of a study, in one scenario under one detection.
 *
 * @param label the strategies, such as {@code A0-P2}, or the bandit and alpha, such as {@code
 *     UCB1@0.5}
 */
public record StudyPlan(RunPlan plan, Kind kind, String label) {
  /** Kinds of networks. */
  public enum Kind {
    /** All cameras have the same strategy. */
    HOMOGENEOUS,
    /** Cameras have different strategies. */
    HETEROGENEOUS,
    /** Cameras choose by a bandit. */
    BANDIT
  }
}
