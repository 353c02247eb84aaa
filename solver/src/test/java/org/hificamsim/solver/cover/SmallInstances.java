package org.hificamsim.solver.cover;

import java.util.SplittableRandom;
import java.util.stream.IntStream;

/** Random instances that are so small that all plans can be tried. */
public final class SmallInstances {
  private SmallInstances() {}

  /**
   * Returns a random instance.
   *
   * @param equal whether all points have a worth of 1 and count once, and all prices are 1;
   *     otherwise worths are 0 to 4, points count up to three times, and prices are 1 to 5
   */
  public static CoverInstance random(
      SplittableRandom random, int points, int candidates, boolean equal) {
    double[] unitWorths =
        random.doubles(points).map(part -> equal ? 1 : Math.rint(4 * part)).toArray();
    int[] needs = random.ints(points, 1, equal ? 2 : 4).toArray();
    int[][] covered = new int[candidates][];
    for (int candidate = 0; candidate < candidates; candidate++) {
      covered[candidate] =
          IntStream.range(0, points).filter(point -> random.nextDouble() < 0.3).toArray();
    }
    double[] prices = random.ints(candidates, 1, equal ? 2 : 6).asDoubleStream().toArray();
    return new CoverInstance(unitWorths, needs, covered, prices);
  }

  /** Returns the best score of all plans. */
  public static double best(CoverInstance instance, Goal goal) {
    double best = goal.isFullCover() ? Double.POSITIVE_INFINITY : 0;
    for (int set = 0; set < 1 << instance.candidates(); set++) {
      int bits = set;
      int[] plan =
          IntStream.range(0, instance.candidates())
              .filter(candidate -> (bits >> candidate & 1) == 1)
              .toArray();
      int[] counts = instance.counts(plan);
      if (goal.isFullCover() && instance.isFullyCovered(counts)) {
        best = Math.min(best, instance.price(plan));
      } else if (!goal.isFullCover() && instance.price(plan) <= goal.budget()) {
        best = Math.max(best, instance.worth(counts));
      }
    }
    return best;
  }
}
