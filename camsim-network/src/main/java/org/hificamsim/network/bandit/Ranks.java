package org.hificamsim.network.bandit;

import java.util.Arrays;

/**
 * All values given so far, as distinct values with their numbers: counts of messages repeat, so
 * that memory grows with the number of different ones alone.
 */
final class Ranks {
  private double[] values = new double[16];
  private long[] counts = new long[16];
  private int size;
  private long total;

  /** The share of the earlier values that are strictly smaller; 0 without any. */
  double shareBelow(double value) {
    long below = 0;
    for (int i = 0; i < size && values[i] < value; i++) {
      below += counts[i];
    }
    return total == 0 ? 0 : (double) below / total;
  }

  void add(double value) {
    total++;
    int place = Arrays.binarySearch(values, 0, size, value);
    if (place < 0) {
      place = -place - 1;
      insert(place, value);
    }
    counts[place]++;
  }

  private void insert(int place, double value) {
    if (size == values.length) {
      values = Arrays.copyOf(values, 2 * size);
      counts = Arrays.copyOf(counts, 2 * size);
    }
    System.arraycopy(values, place, values, place + 1, size - place);
    System.arraycopy(counts, place, counts, place + 1, size - place);
    values[place] = value;
    counts[place] = 0;
    size++;
  }
}
