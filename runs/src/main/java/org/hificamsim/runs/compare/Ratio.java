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
 * The proportion of Table 8.1: the performance of several cases together over that of their optima,
 * a ratio of sums. Intervals come from drawing seeds again, the same seeds for everything in a
 * difference.
 *
 * @param performance the sum over the cases, by seed
 * @param optimum the same of the reference policies
 */
public record Ratio(double[] performance, double[] optimum) {
  /** Cases over their own optima. */
  public static Ratio of(List<CaseResult> cases) {
    return over(cases, cases);
  }

  /** Cases over the optima of other cases. */
  public static Ratio over(List<CaseResult> cases, List<CaseResult> others) {
    return new Ratio(
        sums(cases, run -> run.result().value(Metric.PERFORMANCE)),
        sums(others, ScoredRun::optimum));
  }

  /** Cases over the performance of other cases. */
  public static Ratio overPerformance(List<CaseResult> cases, List<CaseResult> others) {
    return new Ratio(of(cases).performance, of(others).performance);
  }

  private static double[] sums(List<CaseResult> cases, ToDoubleFunction<ScoredRun> figure) {
    double[] sums = new double[cases.get(0).runs().size()];
    for (CaseResult one : cases) {
      Arrays.setAll(sums, seed -> sums[seed] + figure.applyAsDouble(one.runs().get(seed)));
    }
    return sums;
  }

  /** The ratio with its 95% interval; NaN throughout where no optimum is above 0. */
  public Estimate estimate() {
    return Bootstrap.of(performance.length, this::at);
  }

  /** The ratio without its interval, for which nothing is drawn. */
  public double mean() {
    return at(IntStream.range(0, performance.length).toArray());
  }

  /** What this is more than another, with its 95% interval. */
  public Estimate minus(Ratio other) {
    return Bootstrap.of(performance.length, seeds -> at(seeds) - other.at(seeds));
  }

  /** The ratio of some seeds, each given by its number, perhaps repeatedly. */
  public double at(int[] seeds) {
    double over = 0;
    double under = 0;
    for (int seed : seeds) {
      over += performance[seed];
      under += optimum[seed];
    }
    return under == 0 ? Double.NaN : over / under;
  }
}
