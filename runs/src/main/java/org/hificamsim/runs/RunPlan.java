package org.hificamsim.runs;

import java.util.Arrays;
import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.scenario.Scenario;

/**
 * A plan of runs: a scenario, a detection, and the values of the {@link Setting settings} that are
 * kept in neither of them. The plan determines all results of its runs.
 *
 * @param scenario the scenario, with the user's settings in place of those of its file
 * @param keptValues the values of all settings that the plan keeps itself
 * @param sources the sources of settings, which results show; empty if they are not known
 */
public record RunPlan(
    Scenario scenario,
    Detection detection,
    Map<Setting, String> keptValues,
    Map<Setting, SettingSource> sources) {
  /** Creates a plan whose sources of settings are not known. */
  public RunPlan(Scenario scenario, Detection detection, Map<Setting, String> keptValues) {
    this(scenario, detection, keptValues, Map.of());
  }

  /**
   * Creates a plan with all other settings at their defaults.
   *
   * @param policy the policy's name and options; each repeat makes its own instance
   * @param steps the number of steps, 1 to {@link Scenario#MAX_STEPS}; 0 only in {@code camsim}
   * @param seed the seed of the first repeat; repeat i uses seed + i
   * @param repeats the number of repeats, 1 or more
   */
  public RunPlan(
      Scenario scenario, Detection detection, String policy, int steps, long seed, int repeats) {
    this(scenario, detection, keptValues(policy, steps, seed, repeats));
  }

  private static Map<Setting, String> keptValues(String policy, int steps, long seed, int repeats) {
    Map<Setting, String> keptValues = new EnumMap<>(Setting.class);
    Arrays.stream(Setting.values())
        .filter(Setting::isKeptByPlan)
        .forEach(setting -> keptValues.put(setting, setting.fallback()));
    keptValues.put(Setting.POLICY, policy);
    keptValues.put(Setting.STEPS, Integer.toString(steps));
    keptValues.put(Setting.SEED, Long.toString(seed));
    keptValues.put(Setting.REPEAT, Integer.toString(repeats));
    return keptValues;
  }

  /** The value of a setting; empty if it does not apply. */
  public Optional<String> value(Setting setting) {
    return setting.isKeptByPlan()
        ? Optional.of(keptValues.get(setting)).filter(value -> !value.isEmpty())
        : setting.derivedFrom(scenario, detection);
  }

  /** The policy's name and options. */
  public String policy() {
    return keptValues.get(Setting.POLICY);
  }

  /** The network of the cameras with its options; empty if each camera works alone. */
  public String network() {
    return keptValues.get(Setting.NETWORK);
  }

  /** The number of steps of each run. */
  public int steps() {
    return Integer.parseInt(keptValues.get(Setting.STEPS));
  }

  /** The seed of the first repeat. */
  public long seed() {
    return Long.parseLong(keptValues.get(Setting.SEED));
  }

  /** The number of runs. */
  public int repeats() {
    return Integer.parseInt(keptValues.get(Setting.REPEAT));
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
    Map<Setting, String> changed = new EnumMap<>(keptValues);
    changed.put(setting, value);
    return new RunPlan(scenario, detection, changed, sources);
  }
}
