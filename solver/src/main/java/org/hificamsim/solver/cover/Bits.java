package org.hificamsim.solver.cover;

import java.util.BitSet;

/**
 * Sets of small numbers as words of bits: number n is bit {@code n % 64} of word {@code n / 64}.
 */
final class Bits {
  private Bits() {}

  /** Returns an empty set with space for the numbers below {@code size}. */
  static long[] none(int size) {
    return new long[(size + Long.SIZE - 1) / Long.SIZE];
  }

  static void set(long[] bits, int number) {
    bits[number / Long.SIZE] |= 1L << number;
  }

  static boolean has(long[] bits, int number) {
    return (bits[number / Long.SIZE] >>> number & 1) != 0;
  }

  static int count(long[] bits) {
    return countCommon(bits, bits);
  }

  /** Returns the number of members that two sets have in common. */
  static int countCommon(long[] first, long[] second) {
    int count = 0;
    for (int word = 0; word < first.length; word++) {
      count += Long.bitCount(first[word] & second[word]);
    }
    return count;
  }

  /** Returns the members of a set that another set does not have. */
  static long[] without(long[] bits, long[] removed) {
    long[] rest = bits.clone();
    for (int word = 0; word < rest.length; word++) {
      rest[word] &= ~removed[word];
    }
    return rest;
  }

  /** Returns the members of a set in ascending order. */
  static int[] members(long[] bits) {
    return BitSet.valueOf(bits).stream().toArray();
  }
}
