package org.hificamsim.runs;

/** Where the value of a setting comes from; the first that there is counts. */
public enum SettingSource {
  OPTION,
  SCENARIO,
  DEFAULT
}
