package org.hificamsim.core.scenario.spec;

/** When targets move within a step: two published orders exist. */
public enum StepOrder {
  /** Observe, then move: the coverage study. */
  COVERAGE,
  /** Move, then observe: CamSim. */
  CAMSIM
}
