package org.hificamsim.runs;

import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.scenario.Scenario;

/**
 * What is to be run: a scenario, what detects in it, and the {@link Setting settings} that neither
 * of them has. Nothing else decides what a run computes.
 *
 * @param scenario with what was asked for in place of what its file says
 * @param own the values of the settings that the plan itself keeps, all of them
 * @param sources where settings come from, for people; empty where nobody knows
 */
public record RunPlan(
    Scenario scenario,
    Detection detection,
    Map<Setting, String> own,
    Map<Setting, SettingSource> sources) {
  /** A plan whose settings come from nobody knows where. */
  public RunPlan(Scenario scenario, Detection detection, Map<Setting, String> own) {
    this(scenario, detection, own, Map.of());
  }

  /**
   * A plan with all other settings at their defaults.
   *
   * @param policy name and options; each repeat makes its own instance
   * @param steps 0 ({@code camsim} alone) to {@link Scenario#MAX_STEPS}
   * @param seed of the first repeat; repeat i uses seed + i
   * @param repeats 1 or more
   */
  public RunPlan(
      Scenario scenario, Detection detection, String policy, int steps, long seed, int repeats) {
    this(scenario, detection, own(policy, steps, seed, repeats));
  }

  private static Map<Setting, String> own(String policy, int steps, long seed, int repeats) {
    Map<Setting, String> own = Settings.NONE.own(Optional.empty());
    own.put(Setting.POLICY, policy);
    own.put(Setting.STEPS, Integer.toString(steps));
    own.put(Setting.SEED, Long.toString(seed));
    own.put(Setting.REPEAT, Integer.toString(repeats));
    return own;
  }

  /** The policy's name and options. */
  public String policy() {
    return own.get(Setting.POLICY);
  }

  /** The network of the cameras with its options; empty where each works for itself. */
  public String network() {
    return own.get(Setting.NETWORK);
  }

  /** The number of steps of each run. */
  public int steps() {
    return Integer.parseInt(own.get(Setting.STEPS));
  }

  /** The seed of the first repeat. */
  public long seed() {
    return Long.parseLong(own.get(Setting.SEED));
  }

  /** The number of runs. */
  public int repeats() {
    return Integer.parseInt(own.get(Setting.REPEAT));
  }

  /** The steps of all runs together. */
  public long work() {
    return (long) repeats() * steps();
  }

  /** The seed of one repeat. */
  public long seed(int run) {
    return seed() + run;
  }

  /** What a step is scored by. */
  public Objective objective() {
    return scenario.objective();
  }

  /** The same plan under another policy. */
  public RunPlan withPolicy(String policy) {
    return with(Setting.POLICY, policy);
  }

  /** The same plan with another network. */
  public RunPlan withNetwork(String network) {
    return with(Setting.NETWORK, network);
  }

  private RunPlan with(Setting setting, String value) {
    Map<Setting, String> changed = new EnumMap<>(own);
    changed.put(setting, value);
    return new RunPlan(scenario, detection, changed, sources);
  }
}
