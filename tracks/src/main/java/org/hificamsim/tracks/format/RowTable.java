package org.hificamsim.tracks.format;

import java.nio.file.Path;
import java.util.function.Consumer;
import org.hificamsim.core.file.Fields;
import org.hificamsim.core.file.TextLines;
import org.hificamsim.data.CsvReader;

/** Reads the rows of a table between commas, semicolons, tabs or blanks. */
final class RowTable {
  private RowTable() {}

  /**
   * Reads all rows that are not empty.
   *
   * @param expected what kind of table it has to be, in error lines
   */
  static void forEachRow(Recording recording, String expected, Consumer<Fields> rows) {
    Separator separator = recording.start().separator();
    if (separator == Separator.BLANKS) {
      readLines(recording.file(), rows);
      return;
    }
    try (CsvReader table =
        CsvReader.openSeparated(recording.file(), expected, separator.character())) {
      table.forEachRow(rows::accept);
    }
  }

  /**
   * Reads all rows that are not empty and no comments, of a table without quotes.
   *
   * @param expected what kind of table it has to be, in error lines
   */
  static void forEachRowOfNumbers(Recording recording, String expected, Consumer<Fields> rows) {
    if (!recording.start().separator().isBlank()) {
      forEachRow(
          recording,
          expected,
          row -> {
            if (!row.text(0).startsWith("#")) {
              rows.accept(row);
            }
          });
      return;
    }
    try (TextLines lines = TextLines.open(recording.file())) {
      while (lines.nextFields()) {
        rows.accept(lines);
      }
    }
  }

  private static void readLines(Path file, Consumer<Fields> rows) {
    try (TextLines lines = TextLines.open(file)) {
      while (lines.next()) {
        if (lines.count() > 0) {
          rows.accept(new LineFields(lines.place(), lines.text(), Separator.BLANKS));
        }
      }
    }
  }
}
