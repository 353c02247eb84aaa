package org.hificamsim.presentation.view;

import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.runs.Setting;
import org.hificamsim.runs.Settings;

/**
 * The choices under which one of the simulations runs.
 *
 * @param detection name of the model
 * @param threshold in [0, 1]; null for the scenario's or else the model's own
 * @param policy name and options
 */
public record LiveChoice(String detection, Double threshold, String policy) {
  /** The choices as settings, without a detection that is the scenario's own. */
  Settings settings(Scenario scenario) {
    boolean isOwn = scenario.find(Scenario.DETECTION).filter(detection::equals).isPresent();
    Settings settings = isOwn ? Settings.NONE : Settings.NONE.with(Setting.DETECTION, detection);
    return threshold == null ? settings : settings.with(Setting.THRESHOLD, threshold.toString());
  }
}
