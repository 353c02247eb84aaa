package org.hificamsim.core.file;

/**
 * Writes doubles as {@link Double#toString} does, and remembers those written lately: in a table of
 * steps most numbers occur again and again, and turning one into text takes as long as a tenth of a
 * step.
 */
final class DoubleTexts {
  private static final int SLOT_BITS = 10;
  private static final long GOLDEN_RATIO = 0x9E3779B97F4A7C15L;

  private final long[] bits = new long[1 << SLOT_BITS];
  private final String[] texts = new String[1 << SLOT_BITS];

  /** Returns the text of a number. */
  String text(double number) {
    long numberBits = Double.doubleToRawLongBits(number);
    int slot = (int) ((numberBits * GOLDEN_RATIO) >>> (Long.SIZE - SLOT_BITS));
    if (texts[slot] == null || bits[slot] != numberBits) {
      bits[slot] = numberBits;
      texts[slot] = Double.toString(number);
    }
    return texts[slot];
  }
}
