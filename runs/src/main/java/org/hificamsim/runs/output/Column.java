package org.hificamsim.runs.output;

import java.util.function.Function;
import org.hificamsim.core.file.Rows;

/**
 * A column of a table. It is declared once; writers, readers and {@code docs/data.md} follow.
 *
 * @param <R> the type that a row is made of
 * @param name the name in the table
 * @param kind the kind of the cells
 * @param unit the unit of the numbers; empty if they have none
 * @param meaning the meaning, for the documentation
 * @param cell writes the cell of a row
 */
public record Column<R>(String name, Kind kind, String unit, String meaning, Cell<R> cell) {
  /** The type of the cells. */
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

  /** Writes the cell of a row, without boxing numbers. */
  @FunctionalInterface
  public interface Cell<R> {
    /** Writes the cell. */
    void add(R row, Rows to);
  }

  /** Adapts the column to a table whose rows contain an object of this column's type. */
  <S> Column<S> forPart(Function<S, R> part) {
    return new Column<>(name, kind, unit, meaning, (row, to) -> cell.add(part.apply(row), to));
  }
}
