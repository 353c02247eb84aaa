package org.hificamsim.runs;

import java.math.BigDecimal;
import java.math.MathContext;

/** Writes numbers for sentences, with three significant digits. */
public final class ShortNumber {
  private static final MathContext THREE_DIGITS = new MathContext(3);

  private ShortNumber() {}

  /** The number, rounded, without an exponent and without zeros at its end. */
  public static String of(double value) {
    return new BigDecimal(value).round(THREE_DIGITS).stripTrailingZeros().toPlainString();
  }
}
