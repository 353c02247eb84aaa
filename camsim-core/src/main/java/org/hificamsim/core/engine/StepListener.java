package org.hificamsim.core.engine;

import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.policy.ZoomPolicy;

/**
 * Watches a run from outside the loop: data collection, progress, recording. An extension point.
 *
 * <p>An implementer writes {@link #stepped}. Both arguments are live and change with the next step:
 * copy what is to be kept.
 */
@FunctionalInterface
public interface StepListener {
  /** Called at the end of each step, after the observation was measured. */
  void stepped(OracleView network, StepCoverage coverage);

  /** The name by which {@code run --listener NAME} finds it among users' jars. */
  default String name() {
    return getClass().getSimpleName();
  }

  /** Called once, before the first step. */
  default void started(OracleView network) {}

  /**
   * Called once before the first step, for a listener that also looks at what the agents know.
   *
   * @param policy what decides in this run; to be asked, not to be driven
   */
  default void started(OracleView network, ZoomPolicy policy) {
    started(network);
  }

  /** Called once after the last step. */
  default void ended(OracleView network) {}
}
