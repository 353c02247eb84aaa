package org.hificamsim.core.scenario.spec;

/** The order in which targets move and cameras look within a step; both orders are published. */
public enum StepOrder {
  /** Observe, then move: the coverage study. */
  COVERAGE,
  /** Move, then observe: CamSim. */
  CAMSIM
}
