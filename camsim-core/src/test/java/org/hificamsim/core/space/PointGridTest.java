package org.hificamsim.core.space;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PointGridTest {
  @Property(tries = 200, edgeCases = EdgeCasesMode.NONE)
  void surroundingCellsHoldEveryPointWithinReach(@ForAll long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    double side = random.nextDouble(0.1, 8);
    PointGrid grid = PointGrid.over(-10, -10, 20, random.nextInt(1, 40), side, 100);
    double[] x = new double[100];
    double[] y = new double[100];
    grid.clear();
    for (int point = 0; point < 100; point++) {
      x[point] = coordinate(random, side);
      y[point] = coordinate(random, side);
      grid.add(point, x[point], y[point]);
    }
    grid.sort();
    for (int query = 0; query < 50; query++) {
      double atX = coordinate(random, side);
      double atY = coordinate(random, side);
      double reach = random.nextInt(4) == 0 ? side : random.nextDouble(15);
      boolean[] met = pointsAround(grid, atX, atY, reach);
      for (int point = 0; point < 100; point++) {
        boolean near = Math.abs(x[point] - atX) <= reach && Math.abs(y[point] - atY) <= reach;
        assertTrue(met[point] || !near, "point " + x[point] + ", " + y[point]);
      }
    }
  }

  @Test
  void holdsEveryPointOnce() {
    PointGrid grid = PointGrid.over(0, 0, 10, 10, 1, 500);
    SplittableRandom random = new SplittableRandom(1);
    for (int round = 0; round < 3; round++) {
      grid.clear();
      int points = 100 * (round + 1);
      for (int point = 0; point < points; point++) {
        grid.add(point, random.nextDouble(-2, 12), random.nextDouble(-2, 12));
      }
      grid.sort();
      assertEquals(points, grid.count());
      int[] times = new int[points];
      for (int i = 0; i < points; i++) {
        times[grid.point(i)]++;
        int row = grid.row(grid.y(i));
        int column = grid.column(grid.x(i));
        assertTrue(i >= grid.start(row, column) && i < grid.end(row, column));
      }
      for (int time : times) {
        assertEquals(1, time);
      }
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {1, 0.5, 4})
  void cellsHoldTheirLeftAndLowerBorders(double side) {
    PointGrid grid = PointGrid.over(10, 20, 4 * side, 3 * side, side, 40);
    assertEquals(12, grid.cells());
    double[] columns = {-1e9, -0.1, 0, 0.999, 1, 2.5, 3, 3.999, 4, 1e9};
    double[] rows = {-1e9, -0.1, 0, 0.999, 1, 1.5, 2, 2.999, 3, 1e9};
    int[] column = {0, 0, 0, 0, 1, 2, 3, 3, 3, 3};
    int[] row = {0, 0, 0, 0, 1, 1, 2, 2, 2, 2};
    for (int i = 0; i < columns.length; i++) {
      assertEquals(column[i], grid.column(10 + columns[i] * side), "sides " + columns[i]);
      assertEquals(row[i], grid.row(20 + rows[i] * side), "sides " + rows[i]);
    }
  }

  @Test
  void storesCellsRowByRow() {
    PointGrid grid = PointGrid.over(0, 0, 3, 2, 1, 12);
    for (int round = 0; round < 2; round++) {
      grid.clear();
      for (int point = 11; point >= 0; point--) {
        grid.add(point, point % 3 + 0.5, point / 3 % 2 + 0.5);
      }
      grid.sort();
      for (int cell = 0; cell < 6; cell++) {
        int row = cell / 3;
        int column = cell % 3;
        assertEquals(cell == 5, grid.isLast(column, row));
        assertEquals(2 * cell, grid.start(row, column));
        assertEquals(2 * cell + 2, grid.end(row, column));
        assertEquals(cell + 6, grid.point(2 * cell));
        assertEquals(cell, grid.point(2 * cell + 1));
        assertEquals(column + 0.5, grid.x(2 * cell));
        assertEquals(row + 0.5, grid.y(2 * cell));
      }
    }
  }

  @Test
  void singleCellKeepsOrder() {
    PointGrid grid = PointGrid.single(3);
    grid.clear();
    grid.add(2, 5, 5);
    grid.add(0, -1e300, 7);
    grid.sort();
    assertEquals(1, grid.cells());
    assertEquals(2, grid.point(0));
    assertEquals(0, grid.point(1));
    assertEquals(0, grid.start(grid.row(0), grid.column(0)));
    assertEquals(2, grid.end(grid.row(1e9), grid.column(-1e9)));
  }

  @Test
  void limitsNumberOfCells() {
    assertTrue(PointGrid.over(0, 0, 1e300, 1, 0, 10).cells() <= 44);
    assertTrue(PointGrid.over(0, 0, 1e-300, 1e300, 1e-9, 10).cells() <= 44);
    assertTrue(PointGrid.over(0, 0, 1000, 1000, 0.001, 100_000).cells() <= 400_004);
    assertEquals(1, PointGrid.over(0, 0, 10, 10, 1e9, 10).cells());
  }

  /** Returns a coordinate that is often exactly on the border between cells. */
  private static double coordinate(SplittableRandom random, double side) {
    return random.nextInt(3) == 0
        ? -10 + side * random.nextInt(-2, 25)
        : random.nextDouble(-14, 14);
  }

  private static boolean[] pointsAround(PointGrid grid, double x, double y, double reach) {
    boolean[] met = new boolean[100];
    int right = grid.column(x + reach);
    for (int row = grid.row(y - reach); row <= grid.row(y + reach); row++) {
      for (int i = grid.start(row, grid.column(x - reach)); i < grid.end(row, right); i++) {
        met[grid.point(i)] = true;
      }
    }
    return met;
  }
}
