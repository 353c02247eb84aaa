package org.hificamsim.reproduction.sensitivity;

import java.util.List;
import java.util.Map;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.scenario.Scenario;

/**
 * One value of one parameter, everything else at its default.
 *
 * @param standard whether the value is the default
 * @param scenarios those of Table 7.1, by their names there
 * @param policies what is run for each policy that the parameter can change, by its name
 */
record Variant(
    String value,
    boolean standard,
    Map<String, Scenario> scenarios,
    Detection hifi,
    Detection camsim,
    Map<String, String> policies) {
  /** Both detection models. */
  List<Detection> detections() {
    return List.of(camsim, hifi);
  }
}
