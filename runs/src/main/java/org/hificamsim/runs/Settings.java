package org.hificamsim.runs;

import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.scenario.Scenario;

/**
 * The values of settings that a user asks for, and the defaults of the command where they differ
 * from those of {@link Setting}. Immutable.
 */
public final class Settings {
  /** No setting is asked for. */
  public static final Settings NONE = new Settings(Map.of(), Map.of());

  private final Map<Setting, String> asked;
  private final Map<Setting, String> fallbacks;

  private Settings(Map<Setting, String> asked, Map<Setting, String> fallbacks) {
    this.asked = asked;
    this.fallbacks = fallbacks;
  }

  /**
   * The same settings with a value that is asked for.
   *
   * @throws org.hificamsim.core.InputException when the setting cannot have the value
   */
  public Settings with(Setting setting, String value) {
    setting.check(value);
    return new Settings(with(asked, setting, value), fallbacks);
  }

  /** The same settings with another default of one of them. */
  public Settings orElse(Setting setting, String value) {
    return new Settings(asked, with(fallbacks, setting, value));
  }

  private static Map<Setting, String> with(
      Map<Setting, String> values, Setting setting, String value) {
    Map<Setting, String> changed = new EnumMap<>(Setting.class);
    changed.putAll(values);
    changed.put(setting, value);
    return changed;
  }

  /** The value that is asked for, if any. */
  public Optional<String> asked(Setting setting) {
    return Optional.ofNullable(asked.get(setting));
  }

  /** The value that is asked for, else the default. */
  public String value(Setting setting) {
    return value(setting, Optional.empty());
  }

  /** The value that is asked for, else that of the scenario file, else the default. */
  public String value(Setting setting, Scenario scenario) {
    return value(setting, Optional.of(scenario));
  }

  private String value(Setting setting, Optional<Scenario> scenario) {
    return asked(setting)
        .or(() -> scenario.flatMap(setting::inFile))
        .orElseGet(() -> fallbacks.getOrDefault(setting, setting.fallback()));
  }

  /** The scenario with the requested values instead of those of its file. */
  public Scenario scenario(Scenario file) {
    Scenario scenario = file;
    for (Map.Entry<Setting, String> value : asked.entrySet()) {
      scenario = value.getKey().override(scenario, value.getValue());
    }
    return scenario;
  }

  /** The values of the settings that a plan keeps itself. */
  private Map<Setting, String> keptByPlan(Scenario scenario) {
    Map<Setting, String> values = new EnumMap<>(Setting.class);
    for (Setting setting : Setting.values()) {
      if (setting.isKeptByPlan()) {
        values.put(setting, value(setting, scenario));
      }
    }
    return values;
  }

  /** The source of each setting that a scenario file may have. */
  public Map<Setting, SettingSource> sources(Scenario scenario) {
    Map<Setting, SettingSource> sources = new EnumMap<>(Setting.class);
    for (Setting setting : Setting.values()) {
      if (setting.mayComeFromFile()) {
        sources.put(setting, source(setting, scenario));
      }
    }
    return sources;
  }

  /** The source of a setting that a scenario file may have. */
  public SettingSource source(Setting setting, Scenario scenario) {
    if (setting == Setting.DETECT && Scenario.hasOwnRule(value(Setting.DETECTION, scenario))) {
      return source(Setting.DETECTION, scenario);
    }
    if (setting == Setting.DETECT && asked(Setting.THRESHOLD).isPresent()) {
      return SettingSource.OPTION; // a threshold asks for the rule of thresholds
    }
    if (asked(setting).isPresent()) {
      return SettingSource.OPTION;
    }
    return setting.inFile(scenario).isPresent() ? SettingSource.SCENARIO : SettingSource.DEFAULT;
  }

  /** A plan of runs under the policy that is asked for. */
  public RunPlan plan(Scenario scenario, Detection detection) {
    return new RunPlan(scenario, detection, keptByPlan(scenario), sources(scenario));
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
