package org.hificamsim.cli;

import org.hificamsim.core.NamedSetting;

/** Settings as the command line takes them: {@code --figure-width 88mm} for figure_width. */
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
