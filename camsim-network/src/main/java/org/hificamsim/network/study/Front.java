package org.hificamsim.network.study;

import java.util.Arrays;
import java.util.Comparator;
import java.util.stream.IntStream;

/** Points of utility and cost of which none is beaten: no other has more for less (Pareto). */
public final class Front {
  private Front() {}

  /**
   * The points that no other one beats by more utility at no more cost, or less cost at no less
   * utility; of equal points all. By rising cost.
   *
   * @param utility of each point, to be high
   * @param cost of each point, to be low
   * @param points the places of those that take part
   */
  public static int[] of(double[] utility, double[] cost, int[] points) {
    int[] byCost =
        Arrays.stream(points)
            .boxed()
            .sorted(
                Comparator.<Integer>comparingDouble(point -> cost[point])
                    .thenComparing(Comparator.<Integer>comparingDouble(p -> utility[p]).reversed()))
            .mapToInt(Integer::intValue)
            .toArray();
    IntStream.Builder front = IntStream.builder();
    int last = -1;
    for (int point : byCost) {
      boolean better = last < 0 || utility[point] > utility[last];
      boolean equal = last >= 0 && utility[point] == utility[last] && cost[point] == cost[last];
      if (better || equal) {
        front.add(point);
        last = point;
      }
    }
    return front.build().toArray();
  }

  /**
   * The area that points beat, from utility 0 and the largest cost on.
   *
   * @param mostUtility what counts as 1, as does {@code mostCost} of cost; 0 makes all of it 0
   * @return 0 to 1
   */
  public static double hypervolume(
      double[] utility, double[] cost, int[] points, double mostUtility, double mostCost) {
    if (mostUtility <= 0 || mostCost <= 0) {
      return 0;
    }
    double area = 0;
    double below = 0;
    for (int point : of(utility, cost, points)) {
      area += Math.max(0, utility[point] - below) * Math.max(0, mostCost - cost[point]);
      below = Math.max(below, utility[point]);
    }
    return area / (mostUtility * mostCost);
  }
}
