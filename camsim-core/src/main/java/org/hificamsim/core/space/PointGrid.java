package org.hificamsim.core.space;

import java.util.Arrays;

/**
 * Points of the plane sorted into the square cells of a uniform grid, row by row, so that the
 * points of neighbouring cells in a row are adjacent. Call {@link #clear}, {@link #add} and {@link
 * #sort}; then any number of threads may query.
 *
 * <p>All points within r of a position are in the columns {@code column(x - r)} to {@code column(x
 * + r)} of the rows {@code row(y - r)} to {@code row(y + r)}. Points outside the area belong to the
 * outermost cells, and columns and rows never decrease as a coordinate grows, so no point is
 * missed. A grid of one cell keeps its points in the order in which they were added. It allocates
 * nothing after construction.
 */
public final class PointGrid {
  /** The greatest number of cells for each point, since empty cells take time. */
  private static final int MAX_CELLS_PER_POINT = 4;

  private final double minX;
  private final double minY;
  private final double cellsPerMetre;
  private final int columns;
  private final int rows;

  /** The index of each cell's first point in the order of cells. */
  private final int[] starts;

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
    this.cellsPerMetre = 1 / side;
    this.columns = columns;
    this.rows = rows;
    boolean hasCells = columns * rows > 1;
    starts = new int[columns * rows + 1];
    cells = new int[hasCells ? maxPoints : 0];
    points = new int[maxPoints];
    x = new double[maxPoints];
    y = new double[maxPoints];
    added = hasCells ? new int[maxPoints] : points;
    addedX = hasCells ? new double[maxPoints] : x;
    addedY = hasCells ? new double[maxPoints] : y;
  }

  /** Creates a grid of one cell. */
  public static PointGrid single(int maxPoints) {
    return new PointGrid(0, 0, 1, 1, 1, maxPoints);
  }

  /**
   * Creates a grid over an area.
   *
   * @param width the width of the area, in metres, above 0
   * @param height the height of the area, in metres, above 0
   * @param side the side of a cell, in metres, 0 or more; enlarged if the area would have too many
   *     cells
   */
  public static PointGrid over(
      double minX, double minY, double width, double height, double side, int maxPoints) {
    double maxCells = MAX_CELLS_PER_POINT * (maxPoints + 1.0);
    double cellSide = Math.max(side, Math.max(width, height) / maxCells);
    while (Math.ceil(width / cellSide) * Math.ceil(height / cellSide) > maxCells) {
      cellSide *= 1.25;
    }
    int columns = Math.max(1, (int) Math.ceil(width / cellSide));
    int rows = Math.max(1, (int) Math.ceil(height / cellSide));
    return new PointGrid(minX, minY, cellSide, columns, rows, maxPoints);
  }

  /** The number of cells. */
  public int cells() {
    return columns * rows;
  }

  /** Removes all points. */
  public void clear() {
    count = 0;
  }

  /** Adds a point under a number that the caller chooses. */
  public void add(int point, double newX, double newY) {
    added[count] = point;
    addedX[count] = newX;
    addedY[count] = newY;
    count++;
  }

  /** Sorts the added points into their cells by a counting sort. */
  public void sort() {
    if (cells.length == 0) {
      starts[1] = count;
      return;
    }
    Arrays.fill(starts, 0);
    for (int i = 0; i < count; i++) {
      cells[i] = row(addedY[i]) * columns + column(addedX[i]);
      starts[cells[i]]++;
    }
    int before = 0;
    for (int cell = 0; cell < starts.length; cell++) {
      int first = before;
      before += starts[cell];
      starts[cell] = first;
    }
    // While points are placed, a cell's entry rises from its own start to the start of the next
    // cell.
    for (int i = 0; i < count; i++) {
      int at = starts[cells[i]]++;
      points[at] = added[i];
      x[at] = addedX[i];
      y[at] = addedY[i];
    }
    System.arraycopy(starts, 0, starts, 1, starts.length - 1);
    starts[0] = 0;
  }

  /** The number of points. */
  public int count() {
    return count;
  }

  /** The column of cells that a coordinate belongs to. */
  public int column(double pointX) {
    return Math.max(0, Math.min(columns - 1, (int) ((pointX - minX) * cellsPerMetre)));
  }

  /** The row of cells that a coordinate belongs to. */
  public int row(double pointY) {
    return Math.max(0, Math.min(rows - 1, (int) ((pointY - minY) * cellsPerMetre)));
  }

  /** Whether a column is the last one and a row is the last one. */
  public boolean isLast(int column, int row) {
    return column == columns - 1 && row == rows - 1;
  }

  /** The index of the first point of a cell; the points of the cells to its right follow. */
  public int start(int row, int column) {
    return starts[row * columns + column];
  }

  /** The index after the last point of a cell. */
  public int end(int row, int column) {
    return starts[row * columns + column + 1];
  }

  /**
   * Finds those of some points, in the order of cells, that are nearer than a distance. The
   * distance test is unpredictable, so the sign bit of a difference is read instead of branching.
   *
   * @param below the square of the distance
   * @param near receives the indices of the points, and one entry more may be written
   * @param first the number of entries of {@code near} that are kept
   * @return the number of entries with those found
   */
  public int findNear(
      double fromX, double fromY, double below, int start, int end, long[] near, int first) {
    int found = first;
    for (int i = start; i < end; i++) {
      double dx = x[i] - fromX;
      double dy = y[i] - fromY;
      near[found] = i;
      found += (int) (Double.doubleToRawLongBits(dx * dx + dy * dy - below) >>> 63);
    }
    return found;
  }

  /** The number of the i-th point in the order of cells. */
  public int point(int i) {
    return points[i];
  }

  /** The x coordinate of the i-th point in the order of cells. */
  public double x(int i) {
    return x[i];
  }

  /** The y coordinate of the i-th point in the order of cells. */
  public double y(int i) {
    return y[i];
  }
}
