package org.hificamsim.runs.output;

import java.util.function.Function;
import org.hificamsim.core.file.Rows;

/**
 * A column of a table, declared once; files, their reading and {@code docs/data.md} follow.
 *
 * @param <R> what a row is about
 * @param name in the table
 * @param kind what the cells are
 * @param unit what numbers count or are measured in; empty where there is none
 * @param meaning what it says
 * @param cell writes the cell of a row
 */
public record Column<R>(String name, Kind kind, String unit, String meaning, Cell<R> cell) {
  /** What the cells are. */
  public enum Kind {
    /** Whole numbers of 32 bits. */
    INT,
    /** Whole numbers of 64 bits. */
    LONG,
    /** Floating numbers of 64 bits; NaN is a missing value. */
    DOUBLE,
    /** Texts. */
    TEXT
  }

  /** Writes the cell of a row; no object is made for a number. */
  @FunctionalInterface
  public interface Cell<R> {
    /** Writes it. */
    void add(R row, Rows to);
  }

  /** The same column of a table whose rows have a part that this one is about. */
  <S> Column<S> of(Function<S, R> part) {
    return new Column<>(name, kind, unit, meaning, (row, to) -> cell.add(part.apply(row), to));
  }
}
