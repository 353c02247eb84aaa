package org.hificamsim.presentation.view;

import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.runs.Setting;
import org.hificamsim.runs.Settings;

/**
 * The detection and policy that are chosen for one of the simulations.
 *
 * @param detection the name of the model
 * @param threshold the threshold in [0, 1]; null for that of the scenario or, if it has none, of
 *     the model
 * @param policy the name of the policy with its options
 */
public record LiveChoice(String detection, Double threshold, String policy) {
  /** Returns the choices as settings, which leave out a detection that the scenario has anyway. */
  Settings settings(Scenario scenario) {
    boolean isOfScenario = scenario.find(Scenario.DETECTION).filter(detection::equals).isPresent();
    Settings settings =
        isOfScenario ? Settings.NONE : Settings.NONE.with(Setting.DETECTION, detection);
    return threshold == null ? settings : settings.with(Setting.THRESHOLD, threshold.toString());
  }
}
