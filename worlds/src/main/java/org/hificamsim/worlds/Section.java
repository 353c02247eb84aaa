package org.hificamsim.worlds;

import java.util.List;

/**
 * A part of the block of memory that is shared with who trains: an array, row by row.
 *
 * @param type as NumPy writes it: i4, f4 or u1, in the machine's byte order
 * @param shape its dimensions, the worlds first
 * @param offset where it begins, in bytes
 */
public record Section(String name, String type, List<Integer> shape, int offset) {
  /** How long it is. */
  public int bytes() {
    return size() * (type.equals("u1") ? 1 : Integer.BYTES);
  }

  /** How many numbers it has. */
  public int size() {
    return shape.stream().reduce(1, Math::multiplyExact);
  }
}
