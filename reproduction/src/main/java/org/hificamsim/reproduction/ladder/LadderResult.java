package org.hificamsim.reproduction.ladder;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleBiFunction;
import org.hificamsim.reproduction.ladder.Ladder.RungScenario;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.compare.Cases;
import org.hificamsim.runs.compare.Ratio;

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
        results.add(RungResult.of(place, ladder.policies(), comparison));
        byRung.computeIfAbsent(place.rung(), rung -> new ArrayList<>()).add(comparison);
      }
    }
    byRung.forEach((rung, comparisons) -> results.add(RungResult.ofAll(rung, comparisons)));
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

    static RungResult of(RungScenario place, List<String> policies, RungComparison comparison) {
      return of(
          place.scenario(),
          place.rung(),
          Arrays.stream(comparison.own().best()).mapToObj(policies::get).toList(),
          List.of(comparison));
    }

    static RungResult ofAll(Rung rung, List<RungComparison> scenarios) {
      return of(ALL, rung, List.of(), scenarios);
    }

    private static RungResult of(
        String scenario, Rung rung, List<String> chosen, List<RungComparison> comparisons) {
      return new RungResult(
          scenario,
          rung,
          estimate(comparisons, (one, seeds) -> one.own().optimum(seeds)),
          estimate(comparisons, RungComparison::tau),
          chosen,
          estimate(comparisons, RungComparison::regret),
          estimate(comparisons, RungComparison::share));
    }

    /**
     * The mean over the scenarios that have the figure, with its interval: the same seeds in all.
     */
    private static Estimate estimate(
        List<RungComparison> comparisons, ToDoubleBiFunction<RungComparison, int[]> figure) {
      return Ratio.estimate(
          comparisons.get(0).own().seeds(),
          seeds ->
              comparisons.stream()
                  .mapToDouble(one -> figure.applyAsDouble(one, seeds))
                  .filter(value -> !Double.isNaN(value))
                  .average()
                  .orElse(Double.NaN));
    }
  }
}
