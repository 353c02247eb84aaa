package org.hificamsim.reproduction.ladder;

import java.util.List;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.Settings;
import org.hificamsim.runs.compare.CaseResult;
import org.hificamsim.runs.compare.Cases;

/**
 * A scenario as one rung has it.
 *
 * @param scenario the name of the scenario as it was given
 * @param changed what the rung makes of it
 */
record RungScenario(String scenario, Rung rung, Scenario changed, Detection detection) {
  RunPlan plan(String policy, Settings asked) {
    return asked.plan(changed, detection, policy);
  }

  List<CaseResult> results(Cases cases, List<String> policies) {
    return policies.stream()
        .map(policy -> cases.find(changed.name(), detection.name(), policy))
        .toList();
  }

  /** What tells its results from those of others. */
  List<String> key() {
    return List.of(changed.name(), detection.name());
  }
}
