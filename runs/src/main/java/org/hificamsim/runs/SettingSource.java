package org.hificamsim.runs;

/** Where the value of a setting comes from, in the order of precedence. */
public enum SettingSource {
  OPTION,
  SCENARIO,
  DEFAULT
}
