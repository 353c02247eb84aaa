package org.hificamsim.runs.output;

import java.util.List;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import java.util.function.ToIntFunction;
import java.util.function.ToLongFunction;
import org.hificamsim.core.file.Rows;
import org.hificamsim.runs.Estimate;

/**
 * A column of a table, declared once: its name, what its cells are, their unit and meaning, and how
 * the cell of a row is found. Files, their reading and {@code docs/data.md} follow.
 *
 * @param <R> what a row is about
 */
public final class Column<R> {
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
  private interface Cell<R> {
    void add(R row, Rows to);
  }

  private final String name;
  private final Kind kind;
  private final String unit;
  private final String meaning;
  private final boolean later;
  private final Cell<R> cell;

  private Column(String name, Kind kind, String unit, String meaning, boolean later, Cell<R> cell) {
    this.name = name;
    this.kind = kind;
    this.unit = unit;
    this.meaning = meaning;
    this.later = later;
    this.cell = cell;
  }

  /** Whole numbers of 32 bits. */
  public static <R> Column<R> ofInt(
      String name, String unit, String meaning, ToIntFunction<R> value) {
    return new Column<>(
        name, Kind.INT, unit, meaning, false, (row, to) -> to.add(value.applyAsInt(row)));
  }

  /** Whole numbers of 64 bits. */
  public static <R> Column<R> ofLong(
      String name, String unit, String meaning, ToLongFunction<R> value) {
    return new Column<>(
        name, Kind.LONG, unit, meaning, false, (row, to) -> to.add(value.applyAsLong(row)));
  }

  /** Floating numbers; NaN is an empty cell. */
  public static <R> Column<R> ofDouble(
      String name, String unit, String meaning, ToDoubleFunction<R> value) {
    return new Column<>(
        name, Kind.DOUBLE, unit, meaning, false, (row, to) -> to.add(value.applyAsDouble(row)));
  }

  /** Floating numbers, of which whole ones are written without a fraction. */
  public static <R> Column<R> ofPlain(
      String name, String unit, String meaning, ToDoubleFunction<R> value) {
    return new Column<>(
        name, Kind.DOUBLE, unit, meaning, false, (row, to) -> plain(value.applyAsDouble(row), to));
  }

  private static void plain(double number, Rows to) {
    if (number == Math.rint(number)) {
      to.add((long) number);
    } else {
      to.add(number);
    }
  }

  /** Texts. */
  public static <R> Column<R> ofText(String name, String meaning, Function<R, String> value) {
    return new Column<>(
        name, Kind.TEXT, "", meaning, false, (row, to) -> ((TableRows) to).add(value.apply(row)));
  }

  /** An estimate with the ends of its 95% interval: three columns. */
  public static <R> List<Column<R>> ofEstimate(
      String name,
      String low,
      String high,
      String unit,
      String meaning,
      Function<R, Estimate> value) {
    return List.of(
        ofDouble(name, unit, meaning, row -> value.apply(row).mean()),
        ofDouble(low, unit, "the lower end of its 95% interval", row -> value.apply(row).low()),
        ofDouble(high, unit, "the upper end", row -> value.apply(row).high()));
  }

  /** The same column, which files of earlier versions lack. */
  public Column<R> later() {
    return new Column<>(name, kind, unit, meaning, true, cell);
  }

  /** The same column of a table whose rows have a part that this one is about. */
  <S> Column<S> of(Function<S, R> part) {
    return new Column<>(
        name, kind, unit, meaning, later, (row, to) -> cell.add(part.apply(row), to));
  }

  void add(R row, Rows to) {
    cell.add(row, to);
  }

  /** Its name in the table. */
  public String name() {
    return name;
  }

  /** What the cells are. */
  public Kind kind() {
    return kind;
  }

  /** What numbers count or are measured in; empty where there is none. */
  public String unit() {
    return unit;
  }

  /** What it says. */
  public String meaning() {
    return meaning;
  }

  /** Whether files of earlier versions lack it. */
  public boolean isLater() {
    return later;
  }
}
