package org.hificamsim.profiling.dataset;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.hificamsim.core.file.CsvTable;

/**
 * The columns of a table: their names, and how to get the cell of a row.
 *
 * @param <R> the type of the rows
 */
public final class TableLayout<R> {
  private final List<String> names = new ArrayList<>();
  private final List<Function<R, Object>> cells = new ArrayList<>();

  /** Adds a column and returns this layout. */
  public TableLayout<R> with(String name, Function<R, Object> cell) {
    names.add(name);
    cells.add(cell);
    return this;
  }

  /** Returns a text as a cell, quoted if needed, for tables with commas or semicolons. */
  public static String quoted(String content) {
    String text = CsvTable.harmless(content);
    return text.matches("[^,;\"\\n\\r]*") ? text : '"' + text.replace("\"", "\"\"") + '"';
  }

  /** Returns the names of the columns. */
  public List<String> names() {
    return names;
  }

  /** Returns the cells of a row. */
  public List<String> cells(R row) {
    return cells.stream().map(cell -> String.valueOf(cell.apply(row))).toList();
  }

  /** Returns a CSV table with a line of names and a line for each row; cells are not quoted. */
  public String csv(List<R> rows) {
    return String.join(",", names)
        + "\n"
        + rows.stream().map(this::line).collect(Collectors.joining());
  }

  /** Returns the line of a row, with the end of line. */
  public String line(R row) {
    return String.join(",", cells(row)) + "\n";
  }
}
