package org.hificamsim.profiling.dataset;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;

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
    return Stream.concat(Stream.of(names), rows.stream().map(this::cells))
        .map(line -> String.join(",", line) + "\n")
        .collect(Collectors.joining());
  }
}
