package org.hificamsim.core.space;

import java.util.Arrays;

/**
 * Points of the plane sorted into the square cells of a uniform grid, row by row, so that those of
 * neighbouring cells of a row lie side by side: {@link #clear}, {@link #add}, {@link #sort}, then
 * any number of queries, also from several threads.
 *
 * <p>The points near a place are those of the columns {@code column(x - r)} to {@code column(x +
 * r)} in the rows {@code row(y - r)} to {@code row(y + r)}. Points outside the area belong to the
 * outermost cells: since columns and rows never fall where a coordinate rises, nothing within r is
 * missed wherever it is. A grid of one cell keeps its points in the order in which they were added.
 * Nothing is allocated after construction.
 */
public final class PointGrid {
  /** Cells per point that a grid has room for, so that empty cells cost little. */
  private static final int CELLS_PER_POINT = 4;

  private final double minX;
  private final double minY;
  private final double perMetre;
  private final int columns;
  private final int rows;
  private final int[] ends;
  private final int[] cells;
  private final int[] added;
  private final double[] addedX;
  private final double[] addedY;
  private final int[] points;
  private final double[] x;
  private final double[] y;
  private int count;

  private PointGrid(double minX, double minY, double side, int columns, int rows, int maxPoints) {
    this.minX = minX;
    this.minY = minY;
    this.perMetre = 1 / side;
    this.columns = columns;
    this.rows = rows;
    boolean sorts = columns * rows > 1;
    ends = new int[columns * rows + 1];
    cells = new int[sorts ? maxPoints : 0];
    points = new int[maxPoints];
    x = new double[maxPoints];
    y = new double[maxPoints];
    added = sorts ? new int[maxPoints] : points;
    addedX = sorts ? new double[maxPoints] : x;
    addedY = sorts ? new double[maxPoints] : y;
  }

  /** A grid of one cell. */
  public static PointGrid single(int maxPoints) {
    return new PointGrid(0, 0, 1, 1, 1, maxPoints);
  }

  /**
   * A grid over an area.
   *
   * @param width of the area, metres, above 0
   * @param height of the area, metres, above 0
   * @param side of a cell, metres, 0 or more; larger where the area would take too many cells
   */
  public static PointGrid over(
      double minX, double minY, double width, double height, double side, int maxPoints) {
    double maxCells = CELLS_PER_POINT * (maxPoints + 1.0);
    double enough = Math.max(side, Math.max(width, height) / maxCells);
    while (Math.ceil(width / enough) * Math.ceil(height / enough) > maxCells) {
      enough *= 1.25;
    }
    int columns = Math.max(1, (int) Math.ceil(width / enough));
    int rows = Math.max(1, (int) Math.ceil(height / enough));
    return new PointGrid(minX, minY, enough, columns, rows, maxPoints);
  }

  /** The number of cells. */
  public int cells() {
    return columns * rows;
  }

  /** Forgets all points. */
  public void clear() {
    count = 0;
  }

  /** Adds a point, named by a number of the caller's. */
  public void add(int point, double atX, double atY) {
    added[count] = point;
    addedX[count] = atX;
    addedY[count] = atY;
    count++;
  }

  /** Sorts what was added: a counting sort by cell. */
  public void sort() {
    if (cells.length == 0) {
      ends[1] = count;
      return;
    }
    Arrays.fill(ends, 0);
    for (int i = 0; i < count; i++) {
      cells[i] = row(addedY[i]) * columns + column(addedX[i]);
      ends[cells[i]]++;
    }
    int before = 0;
    for (int cell = 0; cell < ends.length; cell++) {
      int first = before;
      before += ends[cell];
      ends[cell] = first;
    }
    // A cell's entry rises from its first point to its end, which is the next cell's first.
    for (int i = 0; i < count; i++) {
      int at = ends[cells[i]]++;
      points[at] = added[i];
      x[at] = addedX[i];
      y[at] = addedY[i];
    }
    System.arraycopy(ends, 0, ends, 1, ends.length - 1);
    ends[0] = 0;
  }

  /** The number of points. */
  public int count() {
    return count;
  }

  /** The column of cells that a coordinate belongs to. */
  public int column(double atX) {
    return Math.max(0, Math.min(columns - 1, (int) ((atX - minX) * perMetre)));
  }

  /** The row of cells that a coordinate belongs to. */
  public int row(double atY) {
    return Math.max(0, Math.min(rows - 1, (int) ((atY - minY) * perMetre)));
  }

  /** Whether a column is the last one and a row is the last one. */
  public boolean isLast(int column, int row) {
    return column == columns - 1 && row == rows - 1;
  }

  /** Where the points of a cell begin; those of the cells to its right follow. */
  public int start(int row, int column) {
    return ends[row * columns + column];
  }

  /** One more than where the points of a cell end. */
  public int end(int row, int column) {
    return ends[row * columns + column + 1];
  }

  /** The i-th point in the order of cells. */
  public int point(int i) {
    return points[i];
  }

  /** Where the i-th point in the order of cells is. */
  public double x(int i) {
    return x[i];
  }

  /** Where the i-th point in the order of cells is. */
  public double y(int i) {
    return y[i];
  }
}
