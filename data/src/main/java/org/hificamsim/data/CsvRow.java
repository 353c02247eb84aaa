package org.hificamsim.data;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.core.file.CsvTable;
import org.hificamsim.core.file.Fields;

/**
 * A row of a CSV table. Cells are found by index or column name, and errors name their line and
 * column.
 */
public final class CsvRow implements Fields {
  private final CsvReader table;
  private final Map<String, Integer> columns;
  private final String[] texts;

  /** The place of each cell, packed by {@link #place(int, int)}. */
  private final long[] places;

  CsvRow(CsvReader table, Map<String, Integer> columns, String[] texts, long[] places) {
    this.table = table;
    this.columns = columns;
    this.texts = texts;
    this.places = places;
  }

  /** Packs a line and a column into one number. */
  static long place(int line, int column) {
    return (long) line << Integer.SIZE | column;
  }

  @Override
  public int count() {
    return texts.length;
  }

  @Override
  public String text(int cell) {
    return CsvTable.original(texts[cell]);
  }

  @Override
  public double value(int cell) {
    return Fields.value(table.number(texts[cell]));
  }

  @Override
  public Place place(int cell) {
    long place = places[Math.min(cell, places.length - 1)];
    return new Place(table.file(), (int) (place >> Integer.SIZE), (int) place);
  }

  /** Returns the texts of all cells. */
  public List<String> texts() {
    return Arrays.asList(texts);
  }

  /** Returns the line on which the row begins, from 1. */
  public int line() {
    return place(0).line();
  }

  /** Whether the table has a column of this name. */
  public boolean has(String column) {
    return columns.containsKey(column);
  }

  /** Returns the text in a column, which the table must have. */
  public String text(String column) {
    return texts[columns.get(column)];
  }

  /** Returns the place where the cell in a column begins. */
  public Place place(String column) {
    return place(columns.get(column));
  }

  /**
   * Returns the number in a column, from {@code least} to {@code most}.
   *
   * @throws InputException when the cell is not a number in that range
   */
  public double number(String column, double least, double most, String expected) {
    return number(columns.get(column), column, expected, value -> value >= least && value <= most);
  }

  /**
   * Returns the number in a column, or NaN if the cell is empty.
   *
   * @throws InputException when the cell is neither empty nor a number
   */
  public double numberOrNaN(String column) {
    String text = table.number(text(column));
    try {
      return text.isEmpty() ? Double.NaN : Double.parseDouble(text);
    } catch (NumberFormatException e) {
      throw invalid(column, "a number");
    }
  }

  /** Returns the error for the cell in a column. */
  public InputException invalid(String column, String expected) {
    return invalid(columns.get(column), column, expected);
  }
}
