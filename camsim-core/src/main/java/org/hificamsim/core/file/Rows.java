package org.hificamsim.core.file;

import java.io.Closeable;

/** A table under way, cell by cell and row by row. */
public interface Rows extends Closeable {
  /** Adds a cell to the row. */
  void add(long number);

  /** Adds a cell to the row; NaN says that there is no value. */
  void add(double number);

  /** Adds a cell to the row. */
  void add(String text);

  /** Ends the row, which has at least one cell. */
  void end();
}
