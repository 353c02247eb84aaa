package org.hificamsim.runs;

/** The source of a setting's value, in the order of precedence. */
public enum SettingSource {
  OPTION,
  SCENARIO,
  DEFAULT
}
