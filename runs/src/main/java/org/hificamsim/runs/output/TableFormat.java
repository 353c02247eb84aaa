package org.hificamsim.runs.output;

import java.io.IOException;
import java.nio.file.Path;
import java.util.function.Consumer;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.file.Rows;

/** How the tables of a run are written: {@code --format}. */
public interface TableFormat {
  /** Its name, which files end in. */
  String name();

  /** Starts a table in a folder. */
  Rows create(Table<?> table, OutputFolder folder) throws IOException;

  /**
   * Reads a table of numbers, row by row as CSV has it, without the header.
   *
   * @throws org.hificamsim.core.InputException when it is no file of this format
   */
  void each(Path file, Consumer<String> row) throws IOException;
}
