package org.hificamsim.core.engine;

/**
 * What the cameras of a network do together in a step, apart from observing: failing, talking,
 * handing targets over. The loop's one place for it.
 */
public interface Cooperation {
  /** Every camera works for itself. */
  Cooperation NONE = new Cooperation() {};

  /** Called before the cameras decide and observe, after targets moved in CamSim's order. */
  default void prepare() {}

  /** Called after the observation. */
  default void cooperate() {}
}
