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

/** Scenarios x rungs x policies: what is run, and what is compared with what. */
public final class Ladder {
  private final List<Rung> rungs;
  private final List<String> policies;
  private final Map<String, List<RungScenario>> scenarios = new LinkedHashMap<>();

  /**
   * @param scenarios of different names
   * @param rungs the top one last
   * @param policies two or more, with their options
   * @param detections what a rung detects by in a scenario that it has changed
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
      List<RungScenario> places = new ArrayList<>();
      for (Rung rung : rungs) {
        Scenario changed = rung.world().apply(scenario);
        Detection detection = detections.apply(rung, changed);
        places.add(new RungScenario(scenario.name(), rung, changed, detection));
      }
      this.scenarios.put(scenario.name(), places);
    }
    requireDistinct();
  }

  private void requireDistinct() {
    Map<List<String>, Rung> known = new LinkedHashMap<>();
    for (RungScenario one : all()) {
      Rung other = known.put(List.of(one.changed().name(), one.detection().name()), one.rung());
      if (other != null) {
        throw InputException.of(
            "rungs '%s' and '%s' are both detection '%s' in scenario '%s', expected each" + " once",
            other.name(), one.rung().name(), one.detection().name(), one.changed().name());
      }
    }
  }

  /** The rungs, the top one last. */
  public List<Rung> rungs() {
    return rungs;
  }

  /** The policies to choose from. */
  public List<String> policies() {
    return policies;
  }

  /** What the rungs are judged by: k_min, or where a scenario has another objective the score. */
  String measure() {
    return all().stream().anyMatch(one -> one.changed().objective().hasOwnFigure())
        ? "score"
        : "k_min";
  }

  /** Everything that has to be run. */
  public List<RunPlan> plans(Settings asked) {
    return all().stream()
        .flatMap(one -> policies.stream().map(policy -> one.plan(policy, asked)))
        .toList();
  }

  /** Each scenario by name, as each rung has it. */
  Map<String, List<RungScenario>> scenarios() {
    return scenarios;
  }

  /** Every scenario as every rung has it. */
  List<RungScenario> all() {
    return scenarios.values().stream().flatMap(List::stream).toList();
  }

  /**
   * A scenario as one rung has it.
   *
   * @param scenario the name of the scenario as it was given
   * @param changed what the rung makes of it
   */
  record RungScenario(String scenario, Rung rung, Scenario changed, Detection detection) {
    RunPlan plan(String policy, Settings asked) {
      return rung.with(asked).plan(changed, detection, policy);
    }

    List<CaseResult> results(Cases cases, List<String> policies) {
      return policies.stream()
          .map(policy -> cases.find(changed.name(), detection.name(), policy))
          .toList();
    }
  }
}
