package org.hificamsim.core.file;

/**
 * Doubles as text, as {@link Double#toString} writes them, the last ones remembered: in a table of
 * steps most numbers come again and again, and each costs a tenth of a microsecond.
 */
final class DoubleTexts {
  private static final int SLOTS = 1 << 10;

  private final long[] bits = new long[SLOTS];
  private final String[] texts = new String[SLOTS];

  /** The text; empty for NaN. */
  String text(double number) {
    long wanted = Double.doubleToLongBits(number);
    int slot = slot(wanted);
    if (texts[slot] == null || bits[slot] != wanted) {
      bits[slot] = wanted;
      texts[slot] = Double.isNaN(number) ? "" : Double.toString(number);
    }
    return texts[slot];
  }

  /**
   * The upper bits of a product with the golden ratio, which all bits of the number have part in.
   */
  private static int slot(long bits) {
    return (int) ((bits * 0x9E3779B97F4A7C15L) >>> 54);
  }
}
