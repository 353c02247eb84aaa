package org.hificamsim.reproduction.ladder;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiFunction;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.reproduction.ladder.Rungs.Rung;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.Settings;
import org.hificamsim.runs.compare.CaseResult;
import org.hificamsim.runs.compare.Cases;

/** A ladder of rungs of realism: the scenarios, rungs and policies that are run and compared. */
public final class Ladder {
  private final List<Rung> rungs;
  private final List<String> policies;
  private final Map<String, List<RungScenario>> scenarios = new LinkedHashMap<>();

  /**
   * @param scenarios scenarios with different names
   * @param rungs the rungs, the top rung last
   * @param policies two policies or more, with their options
   * @param detections finds the detection of a rung in a scenario that the rung has changed
   * @throws InputException when two rungs are the same, or there are too few policies
   */
  public Ladder(
      List<Scenario> scenarios,
      List<Rung> rungs,
      List<String> policies,
      BiFunction<Rung, Scenario, Detection> detections) {
    this.rungs = List.copyOf(rungs);
    this.policies = List.copyOf(policies);
    if (policies.size() < 2) {
      throw InputException.of(
          "the policies are '%s' alone, expected two or more to choose from", policies.get(0));
    }
    for (Scenario scenario : scenarios) {
      List<RungScenario> variants = new ArrayList<>();
      for (Rung rung : rungs) {
        Scenario changed = rung.world().apply(scenario);
        Detection detection = detections.apply(rung, changed);
        variants.add(new RungScenario(scenario.name(), rung, changed, detection));
      }
      this.scenarios.put(scenario.name(), variants);
    }
    requireDistinct();
  }

  private void requireDistinct() {
    Map<List<String>, Rung> known = new LinkedHashMap<>();
    for (RungScenario rungScenario : all()) {
      Rung other =
          known.put(
              List.of(rungScenario.changed().name(), rungScenario.detection().name()),
              rungScenario.rung());
      if (other != null) {
        throw InputException.of(
            "rungs '%s' and '%s' are both detection '%s' in scenario '%s', expected each" + " once",
            other.name(),
            rungScenario.rung().name(),
            rungScenario.detection().name(),
            rungScenario.changed().name());
      }
    }
  }

  /** The rungs, the top rung last. */
  public List<Rung> rungs() {
    return rungs;
  }

  /** The policies to choose from. */
  public List<String> policies() {
    return policies;
  }

  /** The measure by which rungs are judged: k_min, or the score if a scenario has an objective. */
  String measure() {
    return all().stream()
            .anyMatch(rungScenario -> rungScenario.changed().objective().hasOwnFigure())
        ? "score"
        : "k_min";
  }

  /** The plans of all runs. */
  public List<RunPlan> plans(Settings settings) {
    return all().stream()
        .flatMap(
            rungScenario -> policies.stream().map(policy -> rungScenario.plan(policy, settings)))
        .toList();
  }

  /** The variants of each scenario under the rungs, by its name. */
  Map<String, List<RungScenario>> scenarios() {
    return scenarios;
  }

  /** All variants of all scenarios. */
  List<RungScenario> all() {
    return scenarios.values().stream().flatMap(List::stream).toList();
  }

  /**
   * The variant of a scenario under a rung.
   *
   * @param scenario the name of the given scenario
   * @param changed the variant
   */
  record RungScenario(String scenario, Rung rung, Scenario changed, Detection detection) {
    RunPlan plan(String policy, Settings settings) {
      return rung.with(settings).plan(changed, detection, policy);
    }

    List<CaseResult> results(Cases cases, List<String> policies) {
      return policies.stream()
          .map(policy -> cases.find(changed.name(), detection.name(), policy))
          .toList();
    }
  }
}
