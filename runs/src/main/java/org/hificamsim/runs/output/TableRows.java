package org.hificamsim.runs.output;

import org.hificamsim.core.file.Rows;

/** A table under way that has texts in it too. */
public interface TableRows extends Rows {
  /** Adds a cell to the row. */
  void add(String text);
}
