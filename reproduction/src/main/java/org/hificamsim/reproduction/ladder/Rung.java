package org.hificamsim.reproduction.ladder;

import java.util.Optional;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.DetectionRule;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.runs.DetectionSpec;

/**
 * One degree of realism: what it makes of a scenario, and how targets are detected there.
 *
 * @param name in files, distinct on a ladder
 * @param adds what the rungs below it have not, in a few words
 * @param detection as users name it
 * @param world what it makes of a scenario; one that changes a scenario gives it another name
 */
public record Rung(String name, String adds, String detection, UnaryOperator<Scenario> world) {
  /** A rung that leaves scenarios as they are, under the name of its detection. */
  Rung(String detection, String adds) {
    this(detection, adds, detection, UnaryOperator.identity());
  }

  /**
   * Its detection. One that names no rule is by threshold, whatever a scenario says: a rung is the
   * same in all scenarios.
   *
   * @throws org.hificamsim.core.InputException when there is no such detection
   */
  public DetectionSpec spec(Function<String, DetectionModel> models) {
    DetectionSpec asked = DetectionSpec.parse(detection, models);
    DetectionRule rule = asked.rule().orElseGet(DetectionRule.Threshold::new);
    return new DetectionSpec(asked.model(), asked.threshold(), Optional.of(rule));
  }
}
