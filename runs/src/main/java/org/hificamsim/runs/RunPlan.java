package org.hificamsim.runs;

import java.util.Arrays;
import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.scenario.Scenario;

/**
 * A plan of runs: a scenario, a detection, and the {@link Setting settings} that neither of them
 * keeps. Nothing else decides what a run computes.
 *
 * @param scenario with the user's settings in place of those of its file
 * @param own the values of all settings that the plan keeps itself
 * @param sources where settings come from, for people; empty if that is not known
 */
public record RunPlan(
    Scenario scenario,
    Detection detection,
    Map<Setting, String> own,
    Map<Setting, SettingSource> sources) {
  /** A plan whose sources of settings are not known. */
  public RunPlan(Scenario scenario, Detection detection, Map<Setting, String> own) {
    this(scenario, detection, own, Map.of());
  }

  /**
   * A plan with all other settings at their defaults.
   *
   * @param policy name and options; each repeat makes its own instance
   * @param steps 0 ({@code camsim} alone) to {@link Scenario#MAX_STEPS}
   * @param seed the seed of the first repeat; repeat i uses seed + i
   * @param repeats 1 or more
   */
  public RunPlan(
      Scenario scenario, Detection detection, String policy, int steps, long seed, int repeats) {
    this(scenario, detection, own(policy, steps, seed, repeats));
  }

  private static Map<Setting, String> own(String policy, int steps, long seed, int repeats) {
    Map<Setting, String> own = new EnumMap<>(Setting.class);
    Arrays.stream(Setting.values())
        .filter(Setting::isKeptByPlan)
        .forEach(setting -> own.put(setting, setting.fallback()));
    own.put(Setting.POLICY, policy);
    own.put(Setting.STEPS, Integer.toString(steps));
    own.put(Setting.SEED, Long.toString(seed));
    own.put(Setting.REPEAT, Integer.toString(repeats));
    return own;
  }

  /** The value of a setting; empty if it does not apply. */
  public Optional<String> value(Setting setting) {
    return setting.isKeptByPlan()
        ? Optional.of(own.get(setting)).filter(value -> !value.isEmpty())
        : setting.derivedFrom(scenario, detection);
  }

  /** The policy's name and options. */
  public String policy() {
    return own.get(Setting.POLICY);
  }

  /** The network of the cameras with its options; empty if each camera works alone. */
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

  /** The number of steps of all runs together. */
  public long work() {
    return (long) repeats() * steps();
  }

  /** The seed of one repeat. */
  public long seed(int run) {
    return seed() + run;
  }

  /** The objective that scores a step. */
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
