package org.hificamsim.runs.statistics;

import java.util.Arrays;
import java.util.EnumMap;
import java.util.Locale;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.apache.commons.math3.stat.StatUtils;
import org.hificamsim.runs.Estimate;

/** A number that aggregates all runs of all scenarios; NaN without runs. */
@SuppressWarnings("ImmutableEnumChecker") // functions
public enum Aggregate {
  /** The interquartile mean: without the lowest and the highest quarter of all runs. */
  IQM(strata -> interquartileMean(strata.sorted())),
  /** The mean distance of scores below 1; a score above 1 counts as 1. */
  OPTIMALITY_GAP(
      strata ->
          1
              - StatUtils.mean(
                  DoubleStream.of(strata.sorted()).map(score -> Math.min(score, 1)).toArray())),
  /** The mean of the scenarios' means. */
  MEAN(strata -> StatUtils.mean(strata.means())),
  /** The median of the scenarios' means. */
  MEDIAN(strata -> StatUtils.percentile(strata.means(), 50));

  /** The values of tau of a performance profile: 0 to 1 in hundredths. */
  public static final double[] TAUS =
      IntStream.rangeClosed(0, 100).mapToDouble(percent -> percent / 100.0).toArray();

  private final ToDoubleFunction<Strata> number;

  Aggregate(ToDoubleFunction<Strata> number) {
    this.number = number;
  }

  private static double interquartileMean(double[] sorted) {
    int cut = sorted.length / 4;
    return StatUtils.mean(sorted, cut, sorted.length - 2 * cut);
  }

  /** The number for some scores. */
  public double of(Strata strata) {
    return number.applyAsDouble(strata);
  }

  /** All aggregates with their intervals. */
  public static Map<Aggregate, Estimate> estimates(Strata strata) {
    Estimate[] estimates =
        Bootstrap.all(
            drawn ->
                Arrays.stream(values()).mapToDouble(aggregate -> aggregate.of(drawn)).toArray(),
            strata);
    Map<Aggregate, Estimate> byAggregate = new EnumMap<>(Aggregate.class);
    for (int i = 0; i < estimates.length; i++) {
      byAggregate.put(values()[i], estimates[i]);
    }
    return byAggregate;
  }

  /** The name in files. */
  public String label() {
    return name().toLowerCase(Locale.ROOT);
  }

  /**
   * The performance profile with its intervals: for each of {@link #TAUS} the share of runs whose
   * score is tau or more. At 1 it is the share of runs that were optimal in every step.
   */
  public static Estimate[] profile(Strata strata) {
    return Arrays.stream(Bootstrap.all(Aggregate::shares, strata))
        .map(share -> share.within(0, 1))
        .toArray(Estimate[]::new);
  }

  private static double[] shares(Strata strata) {
    double[] sorted = strata.sorted();
    double[] shares = new double[TAUS.length];
    int below = 0;
    for (int i = 0; i < TAUS.length; i++) {
      while (below < sorted.length && sorted[below] < TAUS[i]) {
        below++;
      }
      shares[i] = (sorted.length - below) / (double) sorted.length;
    }
    return shares;
  }

  /**
   * The probability that a run of one policy has a higher score than a run of another in the same
   * scenario, where a tie counts half (Mann and Whitney's U over the number of pairs); the mean
   * over the scenarios. Runs are not paired by seed.
   *
   * @return NaN if no scenario has runs of both
   */
  public static Estimate improvement(Strata policy, Strata over) {
    return Bootstrap.of(Aggregate::probability, policy, over).within(0, 1);
  }

  /**
   * The probability without an interval; both policies have the same scenarios in the same order.
   */
  static double probability(Strata policy, Strata over) {
    double[][] scores = policy.sortedByScenario();
    double[][] others = over.sortedByScenario();
    double[] shares = new double[scores.length];
    Arrays.setAll(shares, scenario -> share(scores[scenario], others[scenario]));
    return StatUtils.mean(Arrays.stream(shares).filter(share -> !Double.isNaN(share)).toArray());
  }

  /** The probability in one scenario; both policies' scores are in ascending order. */
  private static double share(double[] scores, double[] others) {
    double wins = 0;
    int below = 0;
    int notAbove = 0;
    for (double score : scores) {
      while (below < others.length && others[below] < score) {
        below++;
      }
      while (notAbove < others.length && others[notAbove] <= score) {
        notAbove++;
      }
      wins += (below + notAbove) / 2.0;
    }
    return wins / ((double) scores.length * others.length);
  }
}
