package org.hificamsim.core.channel;

/**
 * How many bits the fields of a message take: whole numbers as few as tell their values apart, real
 * numbers 32. Each message begins with the numbers of its sender and its receiver.
 */
public final class MessageBits {
  /** A real number: a position, a price, a confidence. */
  public static final int REAL = Float.SIZE;

  private MessageBits() {}

  /**
   * The bits of a field.
   *
   * @param values how many values it can have, 1 or more
   */
  public static int of(long values) {
    return Long.SIZE - Long.numberOfLeadingZeros(Math.max(1, values) - 1);
  }

  /** The bits of the address: sender and receiver. */
  public static int address(int cameras) {
    return 2 * of(cameras);
  }
}
