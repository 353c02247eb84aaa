package org.hificamsim.core;

/** Checks that numbers are in their ranges. */
public final class Ranges {
  private Ranges() {}

  /**
   * Returns a number after checking its range.
   *
   * @param name the name of the number, for the message
   * @throws InputException if it is not in [least, greatest], or NaN
   */
  public static double within(String name, double value, double least, double greatest) {
    if (!(value >= least && value <= greatest)) {
      throw InputException.of(
          "%s is %s, expected a number from %s to %s", name, value, least, greatest);
    }
    return value;
  }
}
