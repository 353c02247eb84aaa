package org.hificamsim.reproduction.ladder;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.hificamsim.runs.compare.Cases;

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
      PolicyScores top = PolicyScores.of(last.results(cases, ladder.policies()));
      for (RungScenario place : places) {
        PolicyScores own = PolicyScores.of(place.results(cases, ladder.policies()));
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
}
