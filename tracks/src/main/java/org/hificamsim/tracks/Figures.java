package org.hificamsim.tracks;

import java.math.BigDecimal;
import java.math.MathContext;

/** Numbers as people read them. */
final class Figures {
  private static final MathContext FOUR = new MathContext(4);

  private Figures() {}

  /** Four digits, without an exponent or zeros at the end. */
  static String rounded(double value) {
    if (!Double.isFinite(value)) {
      return "-";
    }
    String plain = new BigDecimal(value).round(FOUR).toPlainString();
    return plain.contains(".") ? plain.replaceFirst("\\.?0+$", "") : plain;
  }
}
