package org.hificamsim.runs.statistics;

import java.util.Arrays;
import java.util.EnumMap;
import java.util.Locale;
import java.util.Map;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import org.apache.commons.math3.stat.StatUtils;
import org.hificamsim.runs.Estimate;

/**
 * The figures that aggregate the scores, 0 or more, of all runs of all scenarios; NaN without runs.
 */
@SuppressWarnings("ImmutableEnumChecker") // functions
public enum Aggregate {
  /** The interquartile mean, which ignores the lowest and the highest quarter of all runs. */
  IQM(strata -> bootstrapped(Aggregate::interquartileMean, strata)),
  /** The mean distance of scores below 1; a score above 1 counts as 1. */
  OPTIMALITY_GAP(
      strata -> strata.map(score -> Math.min(score, 1)).meanOfRuns().complement().within(0, 1)),
  /** The mean of the scenarios' means. */
  MEAN(strata -> strata.mean().within(0, Double.POSITIVE_INFINITY)),
  /** The median of the scenarios' means; the mean if there are one or two. */
  MEDIAN(
      strata -> strata.scenarios() > 2 ? bootstrapped(Aggregate::median, strata) : MEAN.of(strata));

  /** The values of tau of a performance profile: 0 to 1 in hundredths. */
  public static final double[] TAUS =
      IntStream.rangeClosed(0, 100).mapToDouble(percent -> percent / 100.0).toArray();

  private final Function<Strata, Estimate> estimate;

  Aggregate(Function<Strata, Estimate> estimate) {
    this.estimate = estimate;
  }

  /** The interquartile mean without an interval, which needs no bootstrap. */
  public static double interquartileMean(Strata strata) {
    double[] sorted = strata.sorted();
    int cut = sorted.length / 4;
    return StatUtils.mean(sorted, cut, sorted.length - 2 * cut);
  }

  private static double median(Strata strata) {
    return StatUtils.percentile(strata.means(), 50);
  }

  /** Estimates a figure by a bootstrap; its interval is cut to the range of the scores. */
  private static Estimate bootstrapped(ToDoubleFunction<Strata> figure, Strata strata) {
    double[] sorted = strata.sorted();
    return sorted.length == 0
        ? Estimate.single(Double.NaN)
        : Bootstrap.of(figure, strata).within(sorted[0], sorted[sorted.length - 1]);
  }

  /** The figure of scores, with its interval over seeds. */
  public Estimate of(Strata strata) {
    return estimate.apply(strata);
  }

  /** All aggregates of scores with their intervals; without the median if there is one scenario. */
  public static Map<Aggregate, Estimate> estimates(Strata strata) {
    Map<Aggregate, Estimate> byAggregate = new EnumMap<>(Aggregate.class);
    for (Aggregate aggregate : values()) {
      if (aggregate != MEDIAN || strata.scenarios() > 1) {
        byAggregate.put(aggregate, aggregate.of(strata));
      }
    }
    return byAggregate;
  }

  /** The name in files. */
  public String label() {
    return name().toLowerCase(Locale.ROOT);
  }

  /**
   * The performance profile: for each of {@link #TAUS} the share of runs whose score is tau or
   * more, with Wilson's interval (Probable Inference, 1927). At 1 it is the share of runs that were
   * optimal in every step.
   */
  public static Estimate[] profile(Strata strata) {
    double[] sorted = strata.sorted();
    Estimate[] shares = new Estimate[TAUS.length];
    int below = 0;
    for (int i = 0; i < TAUS.length; i++) {
      while (below < sorted.length && sorted[below] < TAUS[i]) {
        below++;
      }
      shares[i] = Shares.of(sorted.length - below, strata);
    }
    return shares;
  }

  /**
   * The probability that a run of one policy has a higher score than a run of the other in the same
   * scenario, where a tie counts half (Mann and Whitney's U divided by the number of pairs); the
   * mean over the scenarios. Runs are not paired by seed.
   *
   * @return NaN if no scenario has runs of both
   */
  public static Estimate improvement(Strata policy, Strata other) {
    return Shares.improvement(probability(policy, other), policy, other);
  }

  /**
   * The probability without an interval; both policies have the same scenarios in the same order.
   */
  static double probability(Strata policy, Strata other) {
    double[][] scores = policy.sortedByScenario();
    double[][] others = other.sortedByScenario();
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
