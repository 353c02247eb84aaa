package org.hificamsim.cli;

import org.hificamsim.core.InputException;

/** Checks the ranges of numeric options. */
final class Numbers {
  private Numbers() {}

  /**
   * Returns the value of an option after checking its range.
   *
   * @throws InputException naming the option when the value is outside [min, max]
   */
  static int inRange(String option, int value, int min, int max) {
    if (value < min || value > max) {
      throw InputException.of(
          "%s is %s, expected a whole number from %s to %s", option, value, min, max);
    }
    return value;
  }

  /**
   * Reads two numbers with a comma between them.
   *
   * @throws InputException naming the option when the text has another form
   */
  static double[] pair(String option, String text, String expected) {
    String[] parts = text.split(",", -1);
    try {
      if (parts.length == 2) {
        return new double[] {Double.parseDouble(parts[0]), Double.parseDouble(parts[1])};
      }
    } catch (NumberFormatException e) {
      // reported below
    }
    throw new InputException("%s is '%s', expected %s".formatted(option, text, expected));
  }
}
