package org.hificamsim.runs.statistics;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Holm's correction for many comparisons (A Simple Sequentially Rejective Multiple Test Procedure,
 * 1979): the chance of even one false finding among all stays below the level that is asked for.
 */
public final class Holm {
  private Holm() {}

  /**
   * The corrected p-values, in the order of those given; NaN stays, and is not counted.
   *
   * @param p of all comparisons that are looked at together
   */
  public static double[] corrected(double[] p) {
    double[] corrected = new double[p.length];
    Arrays.fill(corrected, Double.NaN);
    List<Integer> rising = rising(p);
    double most = 0;
    for (int rank = 0; rank < rising.size(); rank++) {
      int at = rising.get(rank);
      most = Math.max(most, Math.min(1, (rising.size() - rank) * p[at]));
      corrected[at] = most;
    }
    return corrected;
  }

  private static List<Integer> rising(double[] p) {
    return IntStream.range(0, p.length)
        .filter(i -> !Double.isNaN(p[i]))
        .boxed()
        .sorted(Comparator.comparingDouble(i -> p[i]))
        .toList();
  }
}
