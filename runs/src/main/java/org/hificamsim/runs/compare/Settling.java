package org.hificamsim.runs.compare;

/**
 * How soon a run reaches its final level: the first step from which the mean k_min of a window of
 * 5% of the run is at least 90% of the mean over the run's last tenth.
 */
final class Settling {
  private static final double REACHED = 0.9;

  private Settling() {}

  /** The step, from 0; NaN where the final level is 0. */
  static double of(int[] kMin) {
    int tail = Math.max(1, kMin.length / 10);
    int window = Math.max(1, kMin.length / 20);
    double level = REACHED * sum(kMin, kMin.length - tail, kMin.length) / tail * window;
    if (level == 0) {
      return Double.NaN;
    }
    long inWindow = sum(kMin, 0, window);
    for (int start = 0; start + window < kMin.length; start++) {
      if (inWindow >= level) {
        return start;
      }
      inWindow += kMin[start + window] - kMin[start];
    }
    return kMin.length - window;
  }

  private static long sum(int[] values, int from, int to) {
    long sum = 0;
    for (int i = from; i < to; i++) {
      sum += values[i];
    }
    return sum;
  }
}
