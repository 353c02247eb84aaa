package org.hificamsim.runs;

import static org.hificamsim.core.NamedSetting.setting;

import org.hificamsim.core.InputException;

/** Reads thresholds of detection: numbers from 0 to 1. */
final class Threshold {
  private Threshold() {}

  /**
   * The value of the setting {@code threshold}.
   *
   * @throws InputException when it is not a number from 0 to 1
   */
  static double parse(String text) {
    return parse(setting("threshold"), text);
  }

  /**
   * A threshold that is not a setting of its own, such as in {@code hifi:orb-lin@0.05}.
   *
   * @param name the name of the threshold in an error
   * @throws InputException when it is not a number from 0 to 1
   */
  static double parse(String name, String text) {
    try {
      return require(name, Double.parseDouble(text));
    } catch (NumberFormatException e) {
      throw InputException.of("%s is '%s', expected a number from 0 to 1", name, text).because(e);
    }
  }

  /** Returns a threshold after checking that it is a number from 0 to 1. */
  static double require(String name, double threshold) {
    if (!(threshold >= 0 && threshold <= 1)) {
      throw InputException.of("%s is %s, expected a number from 0 to 1", name, threshold);
    }
    return threshold;
  }
}
