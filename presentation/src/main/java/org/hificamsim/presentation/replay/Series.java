package org.hificamsim.presentation.replay;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.stream.LongStream;

/**
 * Writes whole numbers in few bytes, and reads them again. For each number, it writes the
 * difference from the previous one, with the sign in the lowest bit (zigzag), and seven bits in
 * each byte, the lowest ones first (LEB128).
 */
final class Series {
  private static final int BITS = 7;
  private static final int CONTINUES = 1 << BITS;

  private Series() {}

  /** Converts 0, -1, 1, -2, ... to 0, 1, 2, 3, ... */
  static long zigzag(long number) {
    return (number << 1) ^ (number >> (Long.SIZE - 1));
  }

  static long unzigzag(long code) {
    return (code >>> 1) ^ -(code & 1);
  }

  static void write(OutputStream out, LongStream numbers) throws IOException {
    long before = 0;
    for (long number : numbers.toArray()) {
      add(out, number - before);
      before = number;
    }
  }

  private static void add(OutputStream out, long difference) throws IOException {
    long rest = zigzag(difference);
    while ((rest & -CONTINUES) != 0) {
      out.write((int) (rest & (CONTINUES - 1)) | CONTINUES);
      rest >>>= BITS;
    }
    out.write((int) rest);
  }

  /**
   * Reads {@code count} numbers.
   *
   * @throws EOFException if there are fewer
   */
  static long[] read(InputStream in, int count) throws IOException {
    long[] numbers = new long[count];
    for (int i = 0; i < count; i++) {
      numbers[i] = (i == 0 ? 0 : numbers[i - 1]) + next(in);
    }
    return numbers;
  }

  private static long next(InputStream in) throws IOException {
    long code = 0;
    for (int shift = 0; shift < Long.SIZE; shift += BITS) {
      int next = in.read();
      if (next < 0) {
        throw new EOFException();
      }
      code |= (long) (next & (CONTINUES - 1)) << shift;
      if (next < CONTINUES) {
        break;
      }
    }
    return unzigzag(code);
  }
}
