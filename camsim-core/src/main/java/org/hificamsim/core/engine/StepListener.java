package org.hificamsim.core.engine;

import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.policy.ZoomPolicy;

/**
 * Observes a run from outside the loop, for data collection, progress and recording: an extension
 * point.
 *
 * <p>An implementer writes {@link #stepped}. Both arguments change with the next step: copy what is
 * to be kept.
 */
@FunctionalInterface
public interface StepListener {
  /**
   * Called at the end of each step, after the observation was measured. Targets have not moved
   * since it was made.
   */
  void stepped(OracleView network, StepCoverage coverage);

  /** The name by which a run finds it among users' jars. */
  default String name() {
    return getClass().getSimpleName();
  }

  /** Called once, before the first step. */
  default void started(OracleView network) {}

  /**
   * Called once before the first step, for listeners that also report what the policy knows.
   *
   * @param policy the policy of this run; may be queried, must not be driven
   */
  default void started(OracleView network, ZoomPolicy policy) {
    started(network);
  }

  /** Called after the last step of {@link Simulation#run}. */
  default void ended(OracleView network) {}
}
