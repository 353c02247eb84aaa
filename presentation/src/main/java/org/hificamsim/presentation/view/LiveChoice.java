package org.hificamsim.presentation.view;

import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.runs.Setting;
import org.hificamsim.runs.Settings;

/**
 * What one of the simulations runs under.
 *
 * @param detection name of the model
 * @param threshold in [0, 1]; null for the scenario's, else the model's
 * @param policy name and options
 */
public record LiveChoice(String detection, Double threshold, String policy) {
  /** The settings: a detection is asked for unless it is the scenario's own. */
  Settings asked(Scenario scenario) {
    boolean own = scenario.find(Scenario.DETECTION).filter(detection::equals).isPresent();
    Settings asked = own ? Settings.NONE : Settings.NONE.with(Setting.DETECTION, detection);
    return threshold == null ? asked : asked.with(Setting.THRESHOLD, threshold.toString());
  }
}
