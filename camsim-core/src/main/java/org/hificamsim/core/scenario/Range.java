package org.hificamsim.core.scenario;

import java.util.function.DoublePredicate;

/**
 * The finite numbers that an attribute may have. Lengths are at most 1e9 m: beyond any field, and
 * far from what overflows when it is squared or added up.
 *
 * @param expected as error lines say it
 */
record Range(String expected, DoublePredicate valid) {
  private static final double MAX_METRES = 1e9;

  static final Range FINITE = new Range("a finite number", value -> true);
  static final Range COORDINATE =
      new Range("a number from -1e9 to 1e9 (m)", value -> Math.abs(value) <= MAX_METRES);
  static final Range SPEED = new Range("a number from -1e9 to 1e9 (m a step)", COORDINATE.valid());
  static final Range LENGTH =
      new Range("a number from 0 to 1e9 (m)", value -> value >= 0 && value <= MAX_METRES);
  static final Range POSITIVE_LENGTH =
      new Range("a number above 0 and at most 1e9 (m)", value -> value > 0 && value <= MAX_METRES);
  static final Range OPENING_ANGLE =
      new Range("degrees above 0 and at most 360", value -> value > 0 && value <= 360);
  static final Range PROPORTION =
      new Range("a number from 0 to 1", value -> value >= 0 && value <= 1);

  /** The same for a value that a change may leave as it is. */
  Range orUnchanged() {
    return new Range(expected + ", or -1 to leave it", value -> value == -1 || valid.test(value));
  }

  boolean contains(double value) {
    return Double.isFinite(value) && valid.test(value);
  }
}
