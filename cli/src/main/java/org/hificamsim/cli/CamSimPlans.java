package org.hificamsim.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Optional;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.network.CamSimScenario;
import org.hificamsim.network.NetworkSettings;
import org.hificamsim.runs.DetectionSpec;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.Setting;
import org.hificamsim.runs.Settings;

/**
 * Makes plans of CamSim's runs from files and options.
 *
 * @param settings the settings that the user asks for
 * @param movement the name of the movement's class for all objects, if given
 */
record CamSimPlans(
    Settings settings,
    Optional<String> movement,
    NetworkSettings network,
    Catalogue catalogue,
    PrintWriter err) {
  /** Makes the plan of a scenario file. */
  RunPlan plan(Path file) {
    boolean usesZooms = settings.asked(Setting.POLICY).isPresent();
    Scenario scenario =
        settings.scenario(
            CamSimScenario.read(file, movement.orElse(null), usesZooms, network, catalogue, err));
    return settings
        .plan(scenario, DetectionSpec.of(settings, scenario, file, catalogue))
        .withPolicy(settings.asked(Setting.POLICY).orElse("zoom-out"));
  }
}
