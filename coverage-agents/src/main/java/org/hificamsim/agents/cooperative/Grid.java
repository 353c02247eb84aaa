package org.hificamsim.agents.cooperative;

import org.hificamsim.core.scenario.spec.Field;

/** A field divided into equal square cells, numbered row by row; lengths in metres. */
record Grid(double minX, double minY, double side, int columns, int rows) {
  /** Returns a grid of about this many cells. */
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

  /** The number of cells. */
  int cells() {
    return columns * rows;
  }

  /** The cell that contains a point; for a point outside the grid, the nearest one. */
  int cell(double x, double y) {
    return row(y) * columns + column(x);
  }

  int column(double x) {
    return Math.max(0, Math.min(columns - 1, (int) ((x - minX) / side)));
  }

  int row(double y) {
    return Math.max(0, Math.min(rows - 1, (int) ((y - minY) / side)));
  }

  /** The x coordinate of a point in a cell: {@code part} of the cell's width from its left edge. */
  double x(int cell, double part) {
    int column = cell % columns;
    return minX + (column + part) * side;
  }

  /** The y coordinate of a point in a cell: {@code part} of its height from its lower edge. */
  double y(int cell, double part) {
    int row = cell / columns;
    return minY + (row + part) * side;
  }
}
