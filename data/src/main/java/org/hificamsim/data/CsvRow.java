package org.hificamsim.data;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.core.file.CsvTable;
import org.hificamsim.core.file.Fields;

/**
 * A row of a CSV table, whose cells know their place, by number and by the name of their column.
 */
public final class CsvRow implements Fields {
  private final CsvReader table;
  private final Map<String, Integer> columns;
  private final String[] texts;
  private final long[] places; // the line of a cell, then its column

  CsvRow(CsvReader table, Map<String, Integer> columns, String[] texts, long[] places) {
    this.table = table;
    this.columns = columns;
    this.texts = texts;
    this.places = places;
  }

  /** A cell's place as one number. */
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

  /** The texts of all cells. */
  public List<String> texts() {
    return Arrays.asList(texts);
  }

  /** The line on which it begins, from 1. */
  public int line() {
    return place(0).line();
  }

  /** Whether the table has a column of this name. */
  public boolean has(String column) {
    return columns.containsKey(column);
  }

  /** The text in a column that the table has. */
  public String text(String column) {
    return texts[columns.get(column)];
  }

  /** Where the cell in a column begins. */
  public Place place(String column) {
    return place(columns.get(column));
  }

  /**
   * The finite number in a column, from {@code least} to {@code most}.
   *
   * @throws InputException when it is none
   */
  public double number(String column, double least, double most, String expected) {
    return number(columns.get(column), column, expected, value -> value >= least && value <= most);
  }

  /**
   * Any number in a column, NaN where the cell is empty.
   *
   * @throws InputException when it is none
   */
  public double numberOrNaN(String column) {
    String text = table.number(text(column));
    try {
      return text.isEmpty() ? Double.NaN : Double.parseDouble(text);
    } catch (NumberFormatException e) {
      throw invalid(column, "a number");
    }
  }

  /** The fault of the cell in a column. */
  public InputException invalid(String column, String expected) {
    return invalid(columns.get(column), column, expected);
  }
}
