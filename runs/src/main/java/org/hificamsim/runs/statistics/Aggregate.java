package org.hificamsim.runs.statistics;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import org.apache.commons.math3.stat.StatUtils;
import org.hificamsim.runs.Estimate;

/** One number for all runs of all scenarios; NaN where there is no run. */
@SuppressWarnings("ImmutableEnumChecker") // functions
public enum Aggregate {
  /** The interquartile mean: without the lowest and the highest quarter of all runs. */
  IQM(strata -> interquartileMean(strata.sorted())),
  /** How far the runs fall short of 1 on average; what is above 1 counts as 1. */
  OPTIMALITY_GAP(
      strata ->
          1
              - StatUtils.mean(
                  DoubleStream.of(strata.sorted()).map(one -> Math.min(one, 1)).toArray())),
  /** The mean of the scenarios' means. */
  MEAN(strata -> StatUtils.mean(strata.means())),
  /** The median of the scenarios' means. */
  MEDIAN(strata -> StatUtils.percentile(strata.means(), 50));

  private final ToDoubleFunction<Strata> number;

  Aggregate(ToDoubleFunction<Strata> number) {
    this.number = number;
  }

  private static double interquartileMean(double[] sorted) {
    int cut = sorted.length / 4;
    return StatUtils.mean(sorted, cut, sorted.length - 2 * cut);
  }

  /** The number. */
  public double of(Strata strata) {
    return number.applyAsDouble(strata);
  }

  /** All numbers, each with its interval. */
  public static Map<Aggregate, Estimate> estimates(Strata strata) {
    List<Aggregate> all = List.of(values());
    Estimate[] estimates =
        Bootstrap.all(drawn -> all.stream().mapToDouble(one -> one.of(drawn)).toArray(), strata);
    return all.stream().collect(Collectors.toMap(one -> one, one -> estimates[all.indexOf(one)]));
  }

  /** The name in files. */
  public String label() {
    return name().toLowerCase(Locale.ROOT);
  }
}
