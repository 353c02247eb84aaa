package org.hificamsim.network.study;

import java.util.Arrays;
import java.util.Comparator;
import java.util.stream.IntStream;

/** The Pareto front of points with a utility and a cost. */
public final class Front {
  private Front() {}

  /**
   * Returns the points on the front, by rising cost: those for which no other point has more
   * utility at no more cost, or less cost at no less utility. Equal points are all on the front.
   *
   * @param utility the utility of each point, to be maximised
   * @param cost the cost of each point, to be minimised
   * @param points the indexes of the points to compare
   */
  public static int[] find(double[] utility, double[] cost, int[] points) {
    int[] byCost =
        Arrays.stream(points)
            .boxed()
            .sorted(
                Comparator.<Integer>comparingDouble(point -> cost[point])
                    .thenComparing(
                        Comparator.<Integer>comparingDouble(point -> utility[point]).reversed()))
            .mapToInt(Integer::intValue)
            .toArray();
    IntStream.Builder front = IntStream.builder();
    int previous = -1;
    for (int point : byCost) {
      boolean better = previous < 0 || utility[point] > utility[previous];
      boolean equal =
          previous >= 0 && utility[point] == utility[previous] && cost[point] == cost[previous];
      if (better || equal) {
        front.add(point);
        previous = point;
      }
    }
    return front.build().toArray();
  }

  /**
   * Returns the area dominated by points, relative to the rectangle from utility 0 and cost {@code
   * mostCost} to utility {@code mostUtility} and cost 0.
   *
   * @param mostUtility the largest utility; the result is 0 if it or {@code mostCost} is 0
   * @return 0 to 1
   */
  public static double hypervolume(
      double[] utility, double[] cost, int[] points, double mostUtility, double mostCost) {
    if (mostUtility <= 0 || mostCost <= 0) {
      return 0;
    }
    double area = 0;
    double below = 0;
    for (int point : find(utility, cost, points)) {
      area += Math.max(0, utility[point] - below) * Math.max(0, mostCost - cost[point]);
      below = Math.max(below, utility[point]);
    }
    return area / (mostUtility * mostCost);
  }
}
