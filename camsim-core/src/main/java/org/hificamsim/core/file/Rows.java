package org.hificamsim.core.file;

import java.io.Closeable;

/** Receives a table, cell by cell and row by row. */
public interface Rows extends Closeable {
  /** Adds a cell to the row. */
  void add(long number);

  /** Adds a cell to the row; NaN stands for no value. */
  void add(double number);

  /** Adds a cell to the row. */
  void add(String text);

  /** Ends the row, which must have at least one cell. */
  void end();
}
