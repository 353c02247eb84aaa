package org.hificamsim.core.scenario.declaration;

/**
 * The range of the finite numbers that an attribute may have. Lengths are at most 1e9 m, which is
 * beyond any field and cannot overflow when squared or added.
 *
 * @param expected the range in words, for messages
 * @param min the least number
 * @param max the greatest number
 */
public record Range(String expected, double min, double max) {
  /** The least number above 0. */
  static final double ABOVE_0 = Double.MIN_VALUE;

  static final Range FINITE = new Range("a finite number", -Double.MAX_VALUE, Double.MAX_VALUE);
  public static final Range COORDINATE = new Range("a number from -1e9 to 1e9 (m)", -1e9, 1e9);
  static final Range SPEED = new Range("a number from -1e9 to 1e9 (m a step)", -1e9, 1e9);
  static final Range LENGTH = new Range("a number from 0 to 1e9 (m)", 0, 1e9);
  public static final Range TIME = new Range("a number from 0 to 1e9 (s)", 0, 1e9);
  static final Range PROPORTION = new Range("a number from 0 to 1", 0, 1);
  public static final Range TURN = new Range("degrees from -360 to 360", -360, 360);
  public static final Range TILT = new Range("degrees from -90 to 90", -90, 90);
  public static final Range POSITIVE_LENGTH =
      new Range("a number above 0 and at most 1e9 (m)", ABOVE_0, 1e9);
  public static final Range POSITIVE_TIME =
      new Range("a number above 0 and at most 1e9 (s)", ABOVE_0, 1e9);
  public static final Range NON_NEGATIVE = new Range("a number from 0 to 1e9", 0, 1e9);
  public static final Range POSITIVE = new Range("a number above 0 and at most 1e9", ABOVE_0, 1e9);
  static final Range OPENING = new Range("degrees above 0 and at most 360", ABOVE_0, 360);
  public static final Range UP_TO_180 = new Range("degrees above 0 and at most 180", ABOVE_0, 180);
  public static final Range UP_TO_90 = new Range("degrees above 0 and at most 90", ABOVE_0, 90);
  public static final Range BELOW_180 =
      new Range("degrees above 0 and below 180", ABOVE_0, Math.nextDown(180.0));

  /**
   * Parses a number.
   *
   * @throws IllegalArgumentException if the text is not a number in this range
   */
  double parse(String text) {
    double value = Double.parseDouble(text);
    if (!contains(value)) {
      throw new IllegalArgumentException(expected);
    }
    return value;
  }

  public boolean contains(double value) {
    return value >= min && value <= max;
  }
}
