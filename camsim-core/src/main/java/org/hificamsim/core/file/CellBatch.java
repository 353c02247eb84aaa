package org.hificamsim.core.file;

/** Cells of a table, kept as they were added until they are written. */
final class CellBatch {
  /** How many there is room for. */
  static final int CELLS = 1 << 14;

  private static final byte WHOLE = 0;
  private static final byte FRACTION = 1;
  private static final byte ROW_END = 2;

  private final long[] bits = new long[CELLS];
  private final byte[] kinds = new byte[CELLS];
  private int count;

  /** Whether there is no room for a further cell. */
  boolean isFull() {
    return count == CELLS;
  }

  void add(long number) {
    put(WHOLE, number);
  }

  void add(double number) {
    put(FRACTION, Double.doubleToRawLongBits(number));
  }

  void end() {
    put(ROW_END, 0);
  }

  private void put(byte kind, long cell) {
    bits[count] = cell;
    kinds[count] = kind;
    count++;
  }

  /** Adds all cells to other rows, and keeps none. */
  void moveTo(Rows out) {
    int all = count;
    count = 0;
    for (int i = 0; i < all; i++) {
      switch (kinds[i]) {
        case WHOLE -> out.add(bits[i]);
        case FRACTION -> out.add(Double.longBitsToDouble(bits[i]));
        default -> out.end();
      }
    }
  }
}
