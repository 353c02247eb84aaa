package org.hificamsim.runs;

import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.scenario.Scenario;

/** The settings that users ask for, each with a value that it can have. */
public final class Settings {
  /** Nothing is asked for. */
  public static final Settings NONE = new Settings(Map.of());

  private final Map<Setting, String> asked;

  private Settings(Map<Setting, String> asked) {
    this.asked = asked;
  }

  /**
   * The same settings and another.
   *
   * @throws org.hificamsim.core.InputException when it cannot have the value
   */
  public Settings with(Setting setting, String value) {
    return with(setting, value, setting.label());
  }

  /**
   * The same settings and another.
   *
   * @param name that an error gives the setting
   * @throws org.hificamsim.core.InputException when it cannot have the value
   */
  public Settings with(Setting setting, String value, String name) {
    setting.check(name, value);
    Map<Setting, String> all = new EnumMap<>(Setting.class);
    all.putAll(asked);
    all.put(setting, value);
    return new Settings(all);
  }

  /** What is asked for, if it is. */
  public Optional<String> asked(Setting setting) {
    return Optional.ofNullable(asked.get(setting));
  }

  /** What is asked for, else the default. */
  public String value(Setting setting) {
    return asked.getOrDefault(setting, setting.fallback());
  }

  /** The scenario with what is asked for in place of what its file says. */
  public Scenario scenario(Scenario file) {
    Scenario scenario = file;
    for (Map.Entry<Setting, String> one : asked.entrySet()) {
      scenario = one.getKey().into(scenario, one.getValue());
    }
    return scenario;
  }

  /** The values of all settings that plans keep themselves. */
  Map<Setting, String> own() {
    Map<Setting, String> own = new EnumMap<>(Setting.class);
    for (Setting setting : Setting.values()) {
      if (setting.isOwn()) {
        own.put(setting, value(setting));
      }
    }
    return own;
  }

  /** A plan of runs under the policy that is asked for. */
  public RunPlan plan(Scenario scenario, Detection detection) {
    return new RunPlan(scenario, detection, own());
  }

  /** A plan of runs under another policy. */
  public RunPlan plan(Scenario scenario, Detection detection, String policy) {
    return plan(scenario, detection).withPolicy(policy);
  }

  /** The number of steps. */
  public int steps() {
    return Integer.parseInt(value(Setting.STEPS));
  }

  /** The seed of the first repeat. */
  public long seed() {
    return Long.parseLong(value(Setting.SEED));
  }

  /** The number of repeats. */
  public int repeats() {
    return Integer.parseInt(value(Setting.REPEAT));
  }
}
