package org.hificamsim.runs;

import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.scenario.Scenario;

/**
 * What is to be run: the model's parameters, apart from where results go.
 *
 * @param policy name and options; each repeat makes its own instance
 * @param steps 0 ({@code camsim} alone) to {@link #MAX_STEPS}
 * @param seed of the first repeat; repeat i uses seed + i
 * @param repeats 1 or more
 */
public record RunPlan(
    Scenario scenario, Detection detection, String policy, int steps, long seed, int repeats) {
  /** The longest run. */
  public static final int MAX_STEPS = 1_000_000_000;

  /** The seed of one repeat. */
  public long seed(int run) {
    return seed + run;
  }

  /** What a step is scored by: the scenario has what was asked for. */
  public Objective objective() {
    return scenario.objective();
  }

  /** The same plan under another policy. */
  public RunPlan withPolicy(String newPolicy) {
    return new RunPlan(scenario, detection, newPolicy, steps, seed, repeats);
  }
}
