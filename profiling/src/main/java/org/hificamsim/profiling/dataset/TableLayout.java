package org.hificamsim.profiling.dataset;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.hificamsim.core.file.CsvTable;

/**
 * A table as data: each column's name, and the cell that a row has there.
 *
 * @param <R> what a row is about
 */
public final class TableLayout<R> {
  private final List<String> names = new ArrayList<>();
  private final List<Function<R, Object>> cells = new ArrayList<>();

  /** Adds a column. */
  public TableLayout<R> with(String name, Function<R, Object> cell) {
    names.add(name);
    cells.add(cell);
    return this;
  }

  /** A text as a cell that reads back from a table between commas or semicolons. */
  public static String quoted(String content) {
    String text = CsvTable.harmless(content);
    return text.matches("[^,;\"\\n\\r]*") ? text : '"' + text.replace("\"", "\"\"") + '"';
  }

  /** The names of the columns. */
  public List<String> names() {
    return names;
  }

  /** The cells of a row. */
  public List<String> cells(R row) {
    return cells.stream().map(cell -> String.valueOf(cell.apply(row))).toList();
  }

  /** A line of names and a line for each row, between commas; each cell is written as it is. */
  public String csv(List<R> rows) {
    return String.join(",", names)
        + "\n"
        + rows.stream().map(this::line).collect(Collectors.joining());
  }

  /** The line of a row, with its end. */
  public String line(R row) {
    return String.join(",", cells(row)) + "\n";
  }
}
