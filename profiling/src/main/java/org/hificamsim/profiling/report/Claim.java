package org.hificamsim.profiling.report;

import org.hificamsim.core.Texts;

/**
 * Something that chapters 4 to 6 say, and what it is on the data set at hand.
 *
 * @param source section or table of the thesis
 * @param published the number or order that it says
 * @param yours the same here
 */
record Claim(String source, String text, String published, String yours, boolean reproduced) {
  /** How far from a published share yours may be to count as the same, as in Table 8.1. */
  static final double TOLERANCE = 0.05;

  private static final double ROUNDING = 1e-9;

  /** That a share has a value. */
  static Claim share(String source, String text, double published, double yours) {
    return new Claim(
        source,
        text,
        number(published),
        number(yours),
        Math.abs(yours - published) <= TOLERANCE + ROUNDING);
  }

  /** That things stand in an order, each named with its number, highest first. */
  static Claim order(String source, String text, String published, String yours) {
    return new Claim(source, text, published, yours, published.equals(yours));
  }

  String verdict() {
    return reproduced ? "reproduced" : "not reproduced";
  }

  private static String number(double value) {
    return Texts.format("%.2f", value);
  }
}
