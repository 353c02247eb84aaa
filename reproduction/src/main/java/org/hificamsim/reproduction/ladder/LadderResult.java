package org.hificamsim.reproduction.ladder;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleBiFunction;
import org.apache.commons.math3.stat.correlation.KendallsCorrelation;
import org.hificamsim.reproduction.ladder.Ladder.RungScenario;
import org.hificamsim.reproduction.ladder.Rungs.Rung;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.compare.Cases;
import org.hificamsim.runs.compare.RungScores;
import org.hificamsim.runs.statistics.Bootstrap;

/**
 * Every rung compared with the top one.
 *
 * @param rungs by scenario, then the means over all scenarios
 * @param nanoseconds what a step costs, by rung
 * @param measure what the rungs are judged by, in a word
 */
public record LadderResult(List<RungResult> rungs, List<Double> nanoseconds, String measure) {
  static LadderResult of(Ladder ladder, Cases cases, List<Double> nanoseconds) {
    List<RungResult> results = new ArrayList<>();
    Map<Rung, List<RungComparison>> byRung = new LinkedHashMap<>();
    for (List<RungScenario> places : ladder.scenarios().values()) {
      RungScenario last = places.get(places.size() - 1);
      RungScores top = RungScores.of(last.results(cases, ladder.policies()));
      for (RungScenario place : places) {
        RungScores own = RungScores.of(place.results(cases, ladder.policies()));
        RungComparison comparison = new RungComparison(own, top);
        List<String> chosen = Arrays.stream(own.best()).mapToObj(ladder.policies()::get).toList();
        results.add(RungResult.of(place.scenario(), place.rung(), chosen, List.of(comparison)));
        byRung.computeIfAbsent(place.rung(), rung -> new ArrayList<>()).add(comparison);
      }
    }
    byRung.forEach((rung, all) -> results.add(RungResult.of(RungResult.ALL, rung, List.of(), all)));
    return new LadderResult(List.copyOf(results), nanoseconds, ladder.measure());
  }

  /** The scenarios' names, then {@link RungResult#ALL}. */
  public List<String> scenarios() {
    return rungs.stream().map(RungResult::scenario).distinct().toList();
  }

  /** The rungs in one scenario, the top one last. */
  public List<RungResult> of(String scenario) {
    return rungs.stream().filter(one -> one.scenario().equals(scenario)).toList();
  }

  /**
   * How good a rung is for a choice of policy: in one scenario, or the mean over all of them.
   *
   * @param scenario {@link #ALL} for the mean
   * @param optimum the mean score that it predicts for the exact optimum
   * @param tau Kendall's tau-b against the top rung; NaN where all policies tie
   * @param chosen the policies that are best under it, more than one where they tie; none for the
   *     mean
   * @param regret the score lost under the top rung by choosing so
   * @param share the same as a share of the top rung's best; NaN where that is 0
   */
  public record RungResult(
      String scenario,
      Rung rung,
      Estimate optimum,
      Estimate tau,
      List<String> chosen,
      Estimate regret,
      Estimate share) {
    /** In place of a scenario's name. */
    public static final String ALL = "all";

    static RungResult of(
        String scenario, Rung rung, List<String> chosen, List<RungComparison> comparisons) {
      return new RungResult(
          scenario,
          rung,
          estimate(comparisons, (one, seeds) -> one.own().optimum(seeds)),
          estimate(comparisons, RungComparison::tau).within(-1, 1),
          chosen,
          estimate(comparisons, RungComparison::regret).within(0, Double.POSITIVE_INFINITY),
          estimate(comparisons, RungComparison::share).within(0, 1));
    }

    /**
     * The mean over the scenarios that have the figure, with its interval: the same seeds in all.
     */
    private static Estimate estimate(
        List<RungComparison> comparisons, ToDoubleBiFunction<RungComparison, int[]> figure) {
      return Bootstrap.of(
          comparisons.get(0).own().seeds(),
          seeds ->
              comparisons.stream()
                  .mapToDouble(one -> figure.applyAsDouble(one, seeds))
                  .filter(value -> !Double.isNaN(value))
                  .average()
                  .orElse(Double.NaN));
    }
  }

  /**
   * A rung compared with the top rung in one scenario; figures are of the seeds that a bootstrap
   * draws.
   */
  record RungComparison(RungScores own, RungScores top) {
    /**
     * How alike both put the policies in order: Kendall's tau-b, 1 for the same order, -1 for the
     * reverse; NaN where either has all policies tie.
     */
    double tau(int[] seeds) {
      return new KendallsCorrelation().correlation(own.means(seeds), top.means(seeds));
    }

    /**
     * The score that is lost under the top rung by choosing the policy that is best under this one,
     * 0 or more; where several are, what is lost on average by choosing any of them. Other seeds
     * may lead to another choice.
     */
    double regret(int[] seeds) {
      return best(seeds) - top.mean(own.best(seeds), seeds);
    }

    /** The regret as a share of the top rung's best; NaN where that is 0. */
    double share(int[] seeds) {
      double best = best(seeds);
      return best == 0 ? Double.NaN : regret(seeds) / best;
    }

    private double best(int[] seeds) {
      return top.mean(top.best(seeds), seeds);
    }
  }
}
