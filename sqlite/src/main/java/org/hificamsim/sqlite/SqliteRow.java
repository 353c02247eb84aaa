package org.hificamsim.sqlite;

import org.hificamsim.core.Place;
import org.hificamsim.core.file.Fields;

/**
 * A row of a table.
 *
 * @param row the number of the row, from 1
 * @param values the cells: texts, numbers or null
 */
record SqliteRow(String file, int row, Object[] values) implements Fields {
  @Override
  public int count() {
    return values.length;
  }

  @Override
  public String text(int field) {
    return values[field] == null ? "" : values[field].toString();
  }

  @Override
  public double value(int field) {
    return values[field] instanceof Number number
        ? number.doubleValue()
        : Fields.value(text(field));
  }

  @Override
  public Place place(int field) {
    return new Place(file, row, 1 + field);
  }
}
