package org.hificamsim.tracks.format;

import java.nio.file.Path;
import java.util.List;
import java.util.ServiceLoader;
import java.util.function.Consumer;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.Fields;

/** Reads SQLite files. The implementation is in a separate module, since its library is big. */
public interface SqliteReader {
  /**
   * Reads a table row by row, in the order in which the file has them. The line of a field's place
   * is the number of its row, the column the number of the field.
   *
   * @param columns the names of the fields
   * @return whether the file has the table
   * @throws InputException if the file is damaged, or the table lacks a column
   */
  boolean read(Path file, String table, List<String> columns, Consumer<Fields> rows);

  /**
   * Returns the reader on the class path.
   *
   * @param file the file to read
   * @throws InputException if there is none
   */
  static SqliteReader find(Path file) {
    return ServiceLoader.load(SqliteReader.class)
        .findFirst()
        .orElseThrow(
            () ->
                InputException.of(
                    "%s: SQLite is not on the class path, expected its jars in CLASSPATH, or a name"
                        + " that ends in .sqlite, for which they are added",
                    file));
  }
}
