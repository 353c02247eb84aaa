package org.hificamsim.cli;

import org.hificamsim.core.NamedSetting;

/** Writes settings as the command line takes them: {@code --figure-width 88mm}. */
enum Flags implements NamedSetting.Notation {
  NOTATION;

  @Override
  public String name(String setting) {
    return "--" + setting.replace('_', '-');
  }

  @Override
  public String assignment(String setting, String value) {
    return name(setting) + " " + value;
  }
}
