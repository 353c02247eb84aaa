package org.hificamsim.core.engine;

/** The phases of a step, in their order. */
public enum StepPhase {
  /** Events of the scenario happen, and a new step begins for all that counts steps. */
  FIRE_EVENTS,
  /**
   * Targets move, where they move before cameras look (CamSim's order). In both orders the
   * cooperation then prepares, and the positions are read at which cameras see targets until the
   * step ends.
   */
  MOVE_BEFORE_LOOKING,
  /**
   * The policy chooses a view for each camera, and the cameras move towards it for the time of one
   * step. The policy can still see through the views of the step before.
   */
  DECIDE,
  /** The cameras look at the targets. */
  OBSERVE,
  /** The cameras trade and hand over targets, where they form a network. */
  COOPERATE,
  /** The policy learns from the observation. */
  LEARN,
  /** Coverage and score are measured. */
  MEASURE,
  /** The listeners are called, before anything moves. */
  REPORT,
  /** Targets move, where cameras look before they move (the coverage study's order). */
  MOVE_AFTER_LOOKING
}
