package org.hificamsim.runs.cells;

import org.hificamsim.core.scenario.spec.Field;

/**
 * A field cut into equal cells that are as square as the field allows, numbered from its lower left
 * corner, row by row upwards.
 *
 * @param columns 1 or more
 * @param rows 1 or more
 */
public record FieldCells(Field field, int columns, int rows) {
  /** The most cells along a side. */
  public static final int MAX = 200;

  /** Along the longer side where nobody says otherwise. */
  public static final int USUAL = 100;

  /**
   * The cells of a field.
   *
   * @param most along its longer side, 1 to {@link #MAX}
   */
  public static FieldCells of(Field field, int most) {
    double edge = Math.max(field.width(), field.height()) / most;
    return new FieldCells(field, along(field.width(), edge), along(field.height(), edge));
  }

  private static int along(double side, double edge) {
    return edge > 0 ? Math.max(1, (int) Math.round(side / edge)) : 1;
  }

  /** How many there are. */
  public int count() {
    return columns * rows;
  }

  /** How wide each is, metres. */
  public double width() {
    return field.width() / columns;
  }

  /** How high each is, metres. */
  public double height() {
    return field.height() / rows;
  }

  /** The middle of a cell, metres. */
  public double x(int cell) {
    return field.minX() + (cell % columns + 0.5) * width();
  }

  /** The middle of a cell, metres. */
  public double y(int cell) {
    int row = cell / columns;
    return field.minY() + (row + 0.5) * height();
  }

  /** The cell that a point is in, -1 outside the field; of two that meet there, the later. */
  public int at(double x, double y) {
    return field.contains(x, y) && !Double.isNaN(x + y) ? row(y) * columns + column(x) : -1;
  }

  /** The column of a place, the nearest one for those outside the field. */
  int column(double x) {
    return index(x - field.minX(), width(), columns);
  }

  /** The row of a place, found in the same way. */
  int row(double y) {
    return index(y - field.minY(), height(), rows);
  }

  private static int index(double from, double edge, int count) {
    return edge > 0 ? (int) Math.max(0, Math.min(count - 1, Math.floor(from / edge))) : 0;
  }
}
