package org.hificamsim.core.channel;

/**
 * The sizes of the fields of a message in bits: the fewest that distinguish all values of a whole
 * number, and 32 for a real number. Each message begins with the numbers of its sender and
 * receiver.
 */
public final class MessageBits {
  /** The bits of a real number, such as a position, a price or a confidence. */
  public static final int REAL = Float.SIZE;

  private MessageBits() {}

  /**
   * Returns the bits of a field.
   *
   * @param values the number of values that the field can have, 1 or more
   */
  public static int of(long values) {
    return Long.SIZE - Long.numberOfLeadingZeros(Math.max(1, values) - 1);
  }

  /** The bits of the numbers of sender and receiver. */
  public static int address(int cameras) {
    return 2 * of(cameras);
  }
}
