package org.hificamsim.runs.heat;

import java.util.Arrays;

/**
 * How cells were covered, summed over steps. Detections are independent, so the chances of no and
 * of one camera follow from those of each.
 */
final class Covering {
  private final double[] none;
  private final double[] one;
  private final double[] sum;
  private final double[] steps0;
  private final double[] steps1;
  private long steps;

  Covering(int cells) {
    none = new double[cells];
    one = new double[cells];
    sum = new double[cells];
    steps0 = new double[cells];
    steps1 = new double[cells];
  }

  /**
   * Adds steps that were alike.
   *
   * @param seen by each camera
   * @param count how many steps
   */
  void add(SeenCells[] seen, long count) {
    Arrays.fill(none, 1);
    Arrays.fill(one, 0);
    for (SeenCells camera : seen) {
      add(camera, count);
    }
    for (int cell = 0; cell < none.length; cell++) {
      steps0[cell] += count * none[cell];
      steps1[cell] += count * one[cell];
    }
    steps += count;
  }

  private void add(SeenCells camera, long count) {
    int[] cells = camera.cells();
    for (int i = 0; i < cells.length; i++) {
      int cell = cells[i];
      double chance = camera.chances()[i];
      sum[cell] += count * chance;
      one[cell] = one[cell] * (1 - chance) + none[cell] * chance;
      none[cell] *= 1 - chance;
    }
  }

  long steps() {
    return steps;
  }

  double meanK(int cell) {
    return sum[cell] / steps;
  }

  double covered0(int cell) {
    return steps0[cell] / steps;
  }

  double covered1(int cell) {
    return steps1[cell] / steps;
  }
}
