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
 * @param movement the name of the movement's class for all objects, if given
 */
record CamSimPlans(
    Settings asked,
    Optional<String> movement,
    NetworkSettings network,
    Catalogue catalogue,
    PrintWriter err) {
  /** The plan for a scenario file. */
  RunPlan plan(Path file) {
    boolean zooms = asked.asked(Setting.POLICY).isPresent();
    Scenario scenario =
        asked.scenario(
            CamSimScenario.read(file, movement.orElse(null), zooms, network, catalogue, err));
    return asked
        .plan(scenario, DetectionSpec.of(asked, scenario, file, catalogue))
        .withPolicy(asked.asked(Setting.POLICY).orElse("zoom-out"));
  }
}
