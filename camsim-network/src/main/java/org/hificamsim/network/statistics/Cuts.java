package org.hificamsim.network.statistics;

import java.util.Arrays;

/** The parameters at which an edge is cut: 0, 1, and crossings between, rising. */
final class Cuts {
  private double[] at = new double[16];
  private int size;

  void add(double parameter) {
    if (parameter > 0 && parameter < 1) {
      if (size == at.length) {
        at = Arrays.copyOf(at, 2 * size);
      }
      at[size++] = parameter;
    }
  }

  double[] sorted() {
    double[] all = Arrays.copyOf(at, size + 2);
    all[size] = 0;
    all[size + 1] = 1;
    Arrays.sort(all);
    return all;
  }
}
