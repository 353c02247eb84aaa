package org.hificamsim.python;

import org.hificamsim.core.NamedSetting;

/**
 * Writes settings as keyword arguments of Python functions: {@code steps=}, or {@code steps=100}.
 */
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
