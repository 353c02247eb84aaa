package org.hificamsim.core.scenario.spec;

/** When targets move within a step; both orders are published. */
public enum StepOrder {
  /** Observe, then move: the coverage study. */
  COVERAGE,
  /** Move, then observe: CamSim. */
  CAMSIM
}
