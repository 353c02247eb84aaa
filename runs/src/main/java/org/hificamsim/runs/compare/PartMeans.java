package org.hificamsim.runs.compare;

/** A run in equal parts, fifty where it is long enough: the mean of k_min in each. */
public final class PartMeans {
  private static final int MAX = 50;

  private PartMeans() {}

  /** The means, part by part. */
  static double[] of(int[] kMin) {
    int parts = Math.min(MAX, kMin.length);
    double[] levels = new double[parts];
    for (int part = 0; part < parts; part++) {
      int from = start(part, parts, kMin.length);
      int to = start(part + 1, parts, kMin.length);
      for (int step = from; step < to; step++) {
        levels[part] += kMin[step] / (double) (to - from);
      }
    }
    return levels;
  }

  /** The step at which a part begins; for {@code part == parts}, the number of steps. */
  public static int start(int part, int parts, int steps) {
    return (int) ((long) part * steps / parts);
  }
}
