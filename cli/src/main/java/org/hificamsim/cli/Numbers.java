package org.hificamsim.cli;

import org.hificamsim.core.InputException;

/** Range checks of numeric options. */
final class Numbers {
  private Numbers() {}

  /**
   * @throws InputException naming the option when the value is outside [least, most]
   */
  static int inRange(String option, int value, int least, int most) {
    if (value < least || value > most) {
      throw new InputException(
          "%s is %d, expected a whole number from %d to %d".formatted(option, value, least, most));
    }
    return value;
  }

  /**
   * @throws InputException when the last repeat's seed would be beyond the largest whole number
   */
  static void seeds(long seed, int repeats) {
    if (seed > Long.MAX_VALUE - (repeats - 1)) {
      throw new InputException(
          "--seed is %d, expected at most %d for %d repeats"
              .formatted(seed, Long.MAX_VALUE - (repeats - 1), repeats));
    }
  }

  /**
   * @throws InputException naming the option when the value is no number in [0, 1]
   */
  static double proportion(String option, double value) {
    if (!(value >= 0 && value <= 1)) {
      throw new InputException("%s is %s, expected a number from 0 to 1".formatted(option, value));
    }
    return value;
  }

  /**
   * @throws InputException naming the option when the value is no number in [least, most]
   */
  static double within(String option, double value, double least, double most) {
    if (!(value >= least && value <= most)) {
      throw new InputException(
          "%s is %s, expected a number from %s to %s".formatted(option, value, least, most));
    }
    return value;
  }
}
