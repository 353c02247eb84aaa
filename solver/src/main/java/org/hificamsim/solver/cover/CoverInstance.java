package org.hificamsim.solver.cover;

import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * A covering problem: points that are to be covered, and candidates with their prices and the
 * points that they cover.
 *
 * @param unitWorths for each point, the worth of covering it once, 0 or more
 * @param needs for each point, the number of times that covering it counts (its redundancy k), 0 or
 *     more
 * @param covered for each candidate, the points that it covers, in ascending order
 * @param prices for each candidate, its price, above 0
 */
public record CoverInstance(double[] unitWorths, int[] needs, int[][] covered, double[] prices) {
  /** Returns an instance of points that are worth 1 when they are covered once. */
  public static CoverInstance of(int points, int[][] covered, double[] prices) {
    double[] unitWorths = new double[points];
    int[] needs = new int[points];
    Arrays.fill(unitWorths, 1);
    Arrays.fill(needs, 1);
    return new CoverInstance(unitWorths, needs, covered, prices);
  }

  /** The number of points. */
  public int points() {
    return unitWorths.length;
  }

  /** The number of candidates. */
  public int candidates() {
    return covered.length;
  }

  /** Returns by point the number of chosen candidates that cover it. */
  public int[] counts(int[] chosen) {
    int[] counts = new int[points()];
    for (int candidate : chosen) {
      for (int point : covered[candidate]) {
        counts[point]++;
      }
    }
    return counts;
  }

  /** Whether every point is covered as often as needed. */
  boolean isFullyCovered(int[] counts) {
    boolean full = true;
    for (int point = 0; point < counts.length; point++) {
      full &= counts[point] >= needs[point];
    }
    return full;
  }

  /**
   * The worth of covering the points.
   *
   * @param counts for each point, the number of times that it is covered
   */
  public double worth(int[] counts) {
    double worth = 0;
    for (int point = 0; point < counts.length; point++) {
      worth += unitWorths[point] * Math.min(needs[point], counts[point]);
    }
    return worth;
  }

  /**
   * The worth of covering some points once more.
   *
   * @param counts for each point, the number of times that it is covered already
   */
  public double gain(int[] counts, int[] points) {
    return Arrays.stream(points)
        .filter(point -> counts[point] < needs[point])
        .mapToDouble(point -> unitWorths[point])
        .sum();
  }

  /** The worth of covering every point as often as needed. */
  public double totalWorth() {
    return worth(needs);
  }

  /** The price of some chosen candidates. */
  public double price(int[] chosen) {
    return Arrays.stream(chosen).mapToDouble(candidate -> prices[candidate]).sum();
  }

  /**
   * Returns the instance that remains if other cameras already cover the points.
   *
   * @param counts for each point, the number of other cameras that cover it
   */
  public CoverInstance remaining(int[] counts) {
    int[] remainingNeeds = new int[needs.length];
    Arrays.setAll(remainingNeeds, point -> Math.max(0, needs[point] - counts[point]));
    return new CoverInstance(unitWorths, remainingNeeds, covered, prices);
  }

  /** Returns the instance in which no point needs more covers than all candidates together give. */
  public CoverInstance coverable() {
    return needingAtMost(counts(IntStream.range(0, candidates()).toArray()));
  }

  /** Returns the instance in which no point needs more covers than a plan gives. */
  CoverInstance needingAtMost(int[] counts) {
    int[] limitedNeeds = new int[needs.length];
    Arrays.setAll(limitedNeeds, point -> Math.min(needs[point], counts[point]));
    return new CoverInstance(unitWorths, limitedNeeds, covered, prices);
  }

  /** Returns the instance without candidates that are {@linkplain Dominance dominated}. */
  public CoverInstance undominated() {
    return with(undominatedCandidates());
  }

  /** The candidates that are not {@linkplain Dominance dominated}, in ascending order. */
  public int[] undominatedCandidates() {
    return Dominance.undominated(this);
  }

  /** Returns the instance with these candidates only. */
  public CoverInstance with(int[] candidates) {
    return new CoverInstance(
        unitWorths,
        needs,
        Arrays.stream(candidates).mapToObj(candidate -> covered[candidate]).toArray(int[][]::new),
        Arrays.stream(candidates).mapToDouble(candidate -> prices[candidate]).toArray());
  }
}
