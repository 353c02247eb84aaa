package org.hificamsim.runs.cells;

import org.hificamsim.core.scenario.spec.Field;

/**
 * A field divided into equal cells that are as square as the field allows. They are numbered from
 * the lower left corner, row by row upwards.
 *
 * @param columns the number of columns, 1 or more
 * @param rows the number of rows, 1 or more
 */
public record FieldCells(Field field, int columns, int rows) {
  /** The most cells along a side. */
  public static final int MAX = 200;

  /** The default number of cells along the longer side. */
  public static final int DEFAULT = 100;

  /**
   * Divides a field into cells.
   *
   * @param along the number of cells along the field's longer side, 1 to {@link #MAX}
   */
  public static FieldCells of(Field field, int along) {
    double edge = Math.max(field.width(), field.height()) / along;
    return new FieldCells(field, count(field.width(), edge), count(field.height(), edge));
  }

  private static int count(double side, double edge) {
    return edge > 0 ? Math.max(1, (int) Math.round(side / edge)) : 1;
  }

  /** The number of cells. */
  public int count() {
    return columns * rows;
  }

  /** The width of a cell, in metres. */
  public double width() {
    return field.width() / columns;
  }

  /** The height of a cell in the plan, in metres. */
  public double height() {
    return field.height() / rows;
  }

  /** The x of a cell's centre, in metres. */
  public double x(int cell) {
    return field.minX() + (cell % columns + 0.5) * width();
  }

  /** The y of a cell's centre, in metres. */
  public double y(int cell) {
    int row = cell / columns;
    return field.minY() + (row + 0.5) * height();
  }

  /** The cell of a point, -1 outside the field; on a border, the cell with the higher number. */
  public int cellAt(double x, double y) {
    return field.contains(x, y) && !Double.isNaN(x + y) ? row(y) * columns + column(x) : -1;
  }

  /** The column of a position; the nearest column if the position is outside the field. */
  int column(double x) {
    return index(x - field.minX(), width(), columns);
  }

  /** The row of a position; the nearest row if the position is outside the field. */
  int row(double y) {
    return index(y - field.minY(), height(), rows);
  }

  private static int index(double from, double edge, int count) {
    return edge > 0 ? (int) Math.max(0, Math.min(count - 1, Math.floor(from / edge))) : 0;
  }
}
