package org.hificamsim.solver.cover;

/** A matrix of bits; each row is a set in the form of {@link Bits}. */
final class BitRows {
  private final long[][] rows;

  BitRows(int rows, int columns) {
    this.rows = new long[rows][Bits.none(columns).length];
  }

  int rows() {
    return rows.length;
  }

  void set(int row, int column) {
    Bits.set(rows[row], column);
  }

  /** A row; not to be changed. */
  long[] row(int row) {
    return rows[row];
  }
}
