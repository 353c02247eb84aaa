package org.hificamsim.reproduction.sensitivity;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.scenario.Scenario;

/**
 * A parameter with the values that are tried, rising.
 *
 * @param parameter name in files
 * @param meaning for people
 */
record ParameterSweep(String parameter, String meaning, List<Variant> variants) {
  /** The policies that the parameter can change. */
  List<String> policies() {
    return List.copyOf(variants.get(0).policies().keySet());
  }

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

    Variant withHifi(Detection other) {
      return new Variant(value, standard, scenarios, other, camsim, policies);
    }

    Variant withCamSim(Detection other) {
      return new Variant(value, standard, scenarios, hifi, other, policies);
    }

    Variant withScenarios(UnaryOperator<Scenario> change) {
      Map<String, Scenario> changed = new LinkedHashMap<>();
      scenarios.forEach((name, scenario) -> changed.put(name, change.apply(scenario)));
      return new Variant(value, standard, changed, hifi, camsim, policies);
    }

    Variant withOption(String option) {
      Map<String, String> changed = new LinkedHashMap<>();
      policies.forEach((name, spec) -> changed.put(name, spec + ":" + option + "=" + value));
      return new Variant(value, standard, scenarios, hifi, camsim, changed);
    }
  }
}
