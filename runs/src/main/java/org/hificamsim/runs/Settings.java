package org.hificamsim.runs;

import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.scenario.Scenario;

/**
 * The settings that users ask for, each with a value that it can have, and the defaults of the
 * command that they use.
 */
public final class Settings {
  /** Nothing is asked for. */
  public static final Settings NONE = new Settings(Map.of(), Map.of());

  private final Map<Setting, String> asked;
  private final Map<Setting, String> fallbacks;

  private Settings(Map<Setting, String> asked, Map<Setting, String> fallbacks) {
    this.asked = asked;
    this.fallbacks = fallbacks;
  }

  /**
   * The same settings and another.
   *
   * @throws org.hificamsim.core.InputException when it cannot have the value
   */
  public Settings with(Setting setting, String value) {
    setting.check(value);
    return new Settings(with(asked, setting, value), fallbacks);
  }

  /** The same settings, one of them with another default. */
  public Settings orElse(Setting setting, String value) {
    return new Settings(asked, with(fallbacks, setting, value));
  }

  private static Map<Setting, String> with(
      Map<Setting, String> values, Setting setting, String value) {
    Map<Setting, String> all = new EnumMap<>(Setting.class);
    all.putAll(values);
    all.put(setting, value);
    return all;
  }

  /** What is asked for, if it is. */
  public Optional<String> asked(Setting setting) {
    return Optional.ofNullable(asked.get(setting));
  }

  /** What is asked for, else the default; of a setting that no scenario names. */
  public String value(Setting setting) {
    return value(setting, Optional.empty());
  }

  /** What is asked for, else what the scenario says, else the default. */
  public String value(Setting setting, Scenario scenario) {
    return value(setting, Optional.of(scenario));
  }

  private String value(Setting setting, Optional<Scenario> scenario) {
    return asked(setting)
        .or(() -> scenario.flatMap(setting::in))
        .orElseGet(() -> fallbacks.getOrDefault(setting, setting.fallback()));
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
  Map<Setting, String> own(Optional<Scenario> scenario) {
    Map<Setting, String> own = new EnumMap<>(Setting.class);
    for (Setting setting : Setting.values()) {
      if (setting.isOwn()) {
        own.put(setting, value(setting, scenario));
      }
    }
    return own;
  }

  /** Where the settings come from that a scenario may name. */
  public Map<Setting, SettingSource> sources(Scenario scenario) {
    Map<Setting, SettingSource> sources = new EnumMap<>(Setting.class);
    for (Setting setting : Setting.values()) {
      if (setting.hasSource()) {
        sources.put(setting, source(setting, scenario));
      }
    }
    return sources;
  }

  /** Where a setting comes from that a scenario may name. */
  public SettingSource source(Setting setting, Scenario scenario) {
    if (setting == Setting.DETECT && Scenario.hasOwnRule(value(Setting.DETECTION, scenario))) {
      return source(Setting.DETECTION, scenario);
    }
    if (setting == Setting.DETECT && asked(Setting.THRESHOLD).isPresent()) {
      return SettingSource.OPTION; // it asks for the rule of thresholds
    }
    if (asked(setting).isPresent()) {
      return SettingSource.OPTION;
    }
    return setting.in(scenario).isPresent() ? SettingSource.SCENARIO : SettingSource.DEFAULT;
  }

  /** A plan of runs under the policy that is asked for. */
  public RunPlan plan(Scenario scenario, Detection detection) {
    return new RunPlan(scenario, detection, own(Optional.of(scenario)), sources(scenario));
  }

  /** A plan of runs under another policy. */
  public RunPlan plan(Scenario scenario, Detection detection, String policy) {
    return plan(scenario, detection).withPolicy(policy);
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
