package org.hificamsim.agents.cooperative;

import org.hificamsim.core.scenario.spec.Field;

/** A field cut into equal square cells, numbered row by row. */
record Grid(double minX, double minY, double side, int columns, int rows) {
  /** A grid of about this many cells. */
  static Grid over(Field field, int cells) {
    double width = Math.max(field.width(), 1e-3);
    double height = Math.max(field.height(), 1e-3);
    double side = Math.max(Math.sqrt(width * height / cells), Math.max(width, height) / cells);
    return new Grid(
        field.minX(),
        field.minY(),
        side,
        Math.max(1, (int) Math.ceil(width / side - 1e-9)),
        Math.max(1, (int) Math.ceil(height / side - 1e-9)));
  }

  int cells() {
    return columns * rows;
  }

  /** The cell that a point is in; the nearest one for a point outside. */
  int cell(double x, double y) {
    return row(y) * columns + column(x);
  }

  int column(double x) {
    return Math.max(0, Math.min(columns - 1, (int) ((x - minX) / side)));
  }

  int row(double y) {
    return Math.max(0, Math.min(rows - 1, (int) ((y - minY) / side)));
  }

  /** The x coordinate of a place in a cell, metres; {@code part} of its width from its left. */
  double x(int cell, double part) {
    int column = cell % columns;
    return minX + (column + part) * side;
  }

  double y(int cell, double part) {
    int row = cell / columns;
    return minY + (row + part) * side;
  }
}
