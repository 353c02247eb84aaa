package org.hificamsim.python;

import org.hificamsim.core.NamedSetting;

/** Settings as arguments of Python's functions: {@code steps=}, or {@code steps=100}. */
enum Keywords implements NamedSetting.Notation {
  NOTATION;

  @Override
  public String name(String setting) {
    return assignment(setting, "");
  }

  @Override
  public String assignment(String setting, String value) {
    return setting + "=" + value;
  }
}
