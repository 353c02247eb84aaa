package org.hificamsim.placement.cover;

import java.util.SplittableRandom;
import java.util.stream.IntStream;

/** Instances of which all plans can be looked at. */
public final class SmallInstances {
  private SmallInstances() {}

  /** Samples worth 0 to 4 that count up to three times, candidates that cost 1, or up to 5. */
  public static CoverInstance random(
      SplittableRandom random, int samples, int candidates, boolean equal) {
    double[] units = random.doubles(samples).map(one -> equal ? 1 : Math.rint(4 * one)).toArray();
    int[] needs = random.ints(samples, 1, equal ? 2 : 4).toArray();
    int[][] columns = new int[candidates][];
    for (int j = 0; j < candidates; j++) {
      columns[j] = IntStream.range(0, samples).filter(s -> random.nextDouble() < 0.3).toArray();
    }
    double[] prices = random.ints(candidates, 1, equal ? 2 : 6).asDoubleStream().toArray();
    return new CoverInstance(units, needs, columns, prices);
  }

  /** The best score that there is. */
  public static double best(CoverInstance instance, Goal goal) {
    double best = goal.isAll() ? Double.POSITIVE_INFINITY : 0;
    for (int set = 0; set < 1 << instance.candidates(); set++) {
      int bits = set;
      int[] plan =
          IntStream.range(0, instance.candidates()).filter(j -> (bits >> j & 1) == 1).toArray();
      int[] counts = instance.counts(plan);
      boolean whole =
          IntStream.range(0, counts.length).allMatch(s -> counts[s] >= instance.needs()[s]);
      if (goal.isAll() && whole) {
        best = Math.min(best, instance.price(plan));
      } else if (!goal.isAll() && instance.price(plan) <= goal.budget()) {
        best = Math.max(best, instance.worth(counts));
      }
    }
    return best;
  }
}
