package org.hificamsim.runs.compare;

import java.util.Arrays;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.ScoredRun;
import org.hificamsim.runs.statistics.Bootstrap;

/**
 * The proportion of Table 8.1: the sum of the performance of several cases over the sum of that of
 * their optima. Intervals are computed by a bootstrap over seeds; both sides of a difference get
 * the same seeds.
 *
 * @param performance for each seed, the performance summed over the cases
 * @param optimum for each seed, the performance of the optima summed over the cases
 */
public record Ratio(double[] performance, double[] optimum) {
  /** The performance of cases over that of their own optima. */
  public static Ratio of(List<CaseResult> cases) {
    return over(cases, cases);
  }

  /** The performance of cases over that of the optima of other cases. */
  public static Ratio over(List<CaseResult> cases, List<CaseResult> others) {
    return new Ratio(
        sums(cases, run -> run.result().value(Metric.PERFORMANCE)),
        sums(others, ScoredRun::optimum));
  }

  /** The performance of cases over that of other cases. */
  public static Ratio overPerformance(List<CaseResult> cases, List<CaseResult> others) {
    return new Ratio(of(cases).performance, of(others).performance);
  }

  private static double[] sums(List<CaseResult> cases, ToDoubleFunction<ScoredRun> value) {
    double[] sums = new double[cases.get(0).runs().size()];
    for (CaseResult result : cases) {
      Arrays.setAll(sums, seed -> sums[seed] + value.applyAsDouble(result.runs().get(seed)));
    }
    return sums;
  }

  /** The ratio with its 95% interval; NaN if no optimum is above 0. */
  public Estimate estimate() {
    return Bootstrap.of(performance.length, this::ofSeeds);
  }

  /** The ratio without an interval, which needs no bootstrap. */
  public double mean() {
    return ofSeeds(IntStream.range(0, performance.length).toArray());
  }

  /** The difference to another ratio with its 95% interval. */
  public Estimate minus(Ratio other) {
    return Bootstrap.of(performance.length, seeds -> ofSeeds(seeds) - other.ofSeeds(seeds));
  }

  /** The ratio for some seeds, given by their numbers, which may repeat. */
  public double ofSeeds(int[] seeds) {
    double numerator = 0;
    double denominator = 0;
    for (int seed : seeds) {
      numerator += performance[seed];
      denominator += optimum[seed];
    }
    return denominator == 0 ? Double.NaN : numerator / denominator;
  }
}
