package org.hificamsim.cli;

import java.util.EnumMap;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.hificamsim.core.InputException;
import org.hificamsim.runs.Setting;
import org.hificamsim.runs.Settings;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Spec;

/** Adds the settings of a run to the options of a command, from their declarations. */
@Command
final class SettingOptions {
  private final Set<Setting> settings;
  private final Set<Setting> withoutDefault = EnumSet.noneOf(Setting.class);
  private final Map<Setting, OptionSpec> options = new EnumMap<>(Setting.class);
  private CommandSpec command;

  private SettingOptions(Set<Setting> settings) {
    this.settings = settings;
  }

  /** Returns options for all settings. */
  static SettingOptions all() {
    return new SettingOptions(EnumSet.allOf(Setting.class));
  }

  /** Returns options for all settings except some. */
  static SettingOptions allBut(Setting... excluded) {
    SettingOptions options = all();
    options.settings.removeAll(List.of(excluded));
    return options;
  }

  /** Returns options for some settings. */
  static SettingOptions of(Setting first, Setting... further) {
    return new SettingOptions(EnumSet.of(first, further));
  }

  /** Removes the default of an option, and returns these options. */
  SettingOptions withoutDefault(Setting setting) {
    withoutDefault.add(setting);
    return this;
  }

  /** Adds the options to those of the command that has this mixin; picocli calls it. */
  @Spec(Spec.Target.MIXEE)
  void addTo(CommandSpec mixee) {
    command = mixee;
    for (Setting setting : settings) {
      OptionSpec option =
          OptionSpec.builder(name(setting))
              .type(setting.kind().type())
              .paramLabel(setting.form())
              .description(setting.meaning())
              .defaultValue(withoutDefault.contains(setting) ? null : setting.fallback())
              .build();
      options.put(setting, option);
      command.addOption(option);
    }
  }

  /**
   * Returns the settings that the user asks for, and the command's defaults of all others.
   *
   * @throws InputException when a setting cannot have its value
   */
  Settings settings() {
    Settings asked = Settings.NONE;
    for (Map.Entry<Setting, OptionSpec> entry : options.entrySet()) {
      OptionSpec option = entry.getValue();
      Object value = option.getValue();
      if (isAsked(option)) {
        asked = asked.with(entry.getKey(), value.toString());
      } else if (value != null) {
        asked = asked.orElse(entry.getKey(), value.toString());
      }
    }
    requireSeedsInRange(asked);
    return asked;
  }

  private boolean isAsked(OptionSpec option) {
    return command.commandLine().getParseResult().hasMatchedOption(option);
  }

  /** Checks that the seed of the last repeat is a 64-bit number, too. */
  private static void requireSeedsInRange(Settings asked) {
    long max = Long.MAX_VALUE - (asked.repeats() - 1);
    if (asked.seed() > max) {
      throw InputException.of(
          "--seed is %s, expected at most %s for %s repeats", asked.seed(), max, asked.repeats());
    }
  }

  private static String name(Setting setting) {
    return Flags.NOTATION.name(setting.label());
  }
}
