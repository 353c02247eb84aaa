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
 * The comparison of every rung with the top rung.
 *
 * @param rungs the rungs of each scenario, then their means over all scenarios
 * @param nanoseconds the cost of a step, by rung
 * @param measure the name of the measure by which rungs are judged
 */
public record LadderResult(List<RungResult> rungs, List<Double> nanoseconds, String measure) {
  static LadderResult of(Ladder ladder, Cases cases, List<Double> nanoseconds) {
    List<RungResult> results = new ArrayList<>();
    Map<Rung, List<RungComparison>> byRung = new LinkedHashMap<>();
    for (List<RungScenario> variants : ladder.scenarios().values()) {
      RungScenario last = variants.get(variants.size() - 1);
      RungScores top = RungScores.of(last.results(cases, ladder.policies()));
      for (RungScenario variant : variants) {
        RungScores own = RungScores.of(variant.results(cases, ladder.policies()));
        RungComparison comparison = new RungComparison(own, top);
        List<String> chosen = Arrays.stream(own.best()).mapToObj(ladder.policies()::get).toList();
        results.add(RungResult.of(variant.scenario(), variant.rung(), chosen, List.of(comparison)));
        byRung.computeIfAbsent(variant.rung(), rung -> new ArrayList<>()).add(comparison);
      }
    }
    byRung.forEach(
        (rung, comparisons) ->
            results.add(RungResult.of(RungResult.ALL, rung, List.of(), comparisons)));
    return new LadderResult(List.copyOf(results), nanoseconds, ladder.measure());
  }

  /** The names of the scenarios, then {@link RungResult#ALL}. */
  public List<String> scenarios() {
    return rungs.stream().map(RungResult::scenario).distinct().toList();
  }

  /** The rungs in one scenario, the top rung last. */
  public List<RungResult> inScenario(String scenario) {
    return rungs.stream().filter(rung -> rung.scenario().equals(scenario)).toList();
  }

  /**
   * The quality of choosing a policy by a rung, in one scenario or as the mean over all of them.
   *
   * @param scenario {@link #ALL} for the mean
   * @param optimum the mean score that the rung predicts for the exact optimum
   * @param tau Kendall's tau-b with the top rung; NaN if all policies tie
   * @param chosen the policies that are best under the rung, several if they tie; empty for the
   *     mean
   * @param regret the score that the choice loses under the top rung
   * @param share the regret as a share of the top rung's best score; NaN if that is 0
   */
  public record RungResult(
      String scenario,
      Rung rung,
      Estimate optimum,
      Estimate tau,
      List<String> chosen,
      Estimate regret,
      Estimate share) {
    /** The name that stands for all scenarios. */
    public static final String ALL = "all";

    static RungResult of(
        String scenario, Rung rung, List<String> chosen, List<RungComparison> comparisons) {
      return new RungResult(
          scenario,
          rung,
          estimate(comparisons, (comparison, seeds) -> comparison.own().optimum(seeds)),
          estimate(comparisons, RungComparison::tau).within(-1, 1),
          chosen,
          estimate(comparisons, RungComparison::regret).within(0, Double.POSITIVE_INFINITY),
          estimate(comparisons, RungComparison::share).within(0, 1));
    }

    /**
     * The mean over the scenarios that have the figure, with its interval. The same seeds are drawn
     * in all scenarios.
     */
    private static Estimate estimate(
        List<RungComparison> comparisons, ToDoubleBiFunction<RungComparison, int[]> figure) {
      return Bootstrap.of(
          comparisons.get(0).own().seeds(),
          seeds ->
              comparisons.stream()
                  .mapToDouble(comparison -> figure.applyAsDouble(comparison, seeds))
                  .filter(value -> !Double.isNaN(value))
                  .average()
                  .orElse(Double.NaN));
    }
  }

  /**
   * The comparison of a rung with the top rung in one scenario; figures are for the seeds that a
   * bootstrap draws.
   */
  record RungComparison(RungScores own, RungScores top) {
    /**
     * The agreement on the order of the policies: Kendall's tau-b, 1 for the same order, -1 for the
     * reverse; NaN if all policies tie under one of the rungs.
     */
    double tau(int[] seeds) {
      return new KendallsCorrelation().correlation(own.means(seeds), top.means(seeds));
    }

    /**
     * The score that is lost under the top rung by choosing the policy that is best under this
     * rung, 0 or more; the mean if several policies tie. Other seeds may lead to another choice.
     */
    double regret(int[] seeds) {
      return best(seeds) - top.mean(own.best(seeds), seeds);
    }

    /** The regret as a share of the top rung's best score; NaN if that is 0. */
    double share(int[] seeds) {
      double best = best(seeds);
      return best == 0 ? Double.NaN : regret(seeds) / best;
    }

    private double best(int[] seeds) {
      return top.mean(top.best(seeds), seeds);
    }
  }
}
