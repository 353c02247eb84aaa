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

/** The options of a command that are settings of a run, made of their declarations: a mixin. */
@Command
final class SettingOptions {
  private final Set<Setting> settings;
  private final Set<Setting> open = EnumSet.noneOf(Setting.class);
  private final Map<Setting, OptionSpec> options = new EnumMap<>(Setting.class);
  private CommandSpec command;

  private SettingOptions(Set<Setting> settings) {
    this.settings = settings;
  }

  /** All settings. */
  static SettingOptions all() {
    return new SettingOptions(EnumSet.allOf(Setting.class));
  }

  /** All settings but these, which the command has otherwise. */
  static SettingOptions allBut(Setting... others) {
    SettingOptions all = all();
    all.settings.removeAll(List.of(others));
    return all;
  }

  /** These settings alone. */
  static SettingOptions of(Setting first, Setting... further) {
    return new SettingOptions(EnumSet.of(first, further));
  }

  /** The same without a default for one of them. */
  SettingOptions open(Setting setting) {
    open.add(setting);
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
              .defaultValue(open.contains(setting) ? null : setting.fallback())
              .build();
      options.put(setting, option);
      command.addOption(option);
    }
  }

  /**
   * The settings as they were asked for, and the defaults of the command for those that were not.
   *
   * @throws InputException when one cannot have its value
   */
  Settings settings() {
    Settings asked = Settings.NONE;
    for (Map.Entry<Setting, OptionSpec> one : options.entrySet()) {
      Object value = one.getValue().getValue();
      if (isAsked(one.getValue())) {
        asked = asked.with(one.getKey(), value.toString());
      } else if (value != null) {
        asked = asked.orElse(one.getKey(), value.toString());
      }
    }
    requireRoom(asked);
    return asked;
  }

  private boolean isAsked(OptionSpec option) {
    return command.commandLine().getParseResult().hasMatchedOption(option);
  }

  /** The last repeat's seed is a whole number of 64 bits too. */
  private static void requireRoom(Settings asked) {
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
