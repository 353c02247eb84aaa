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
 * Plans of runs as CamSim does them, from files and options.
 *
 * @param movement of all objects, a class name, if asked for
 */
record CamSimPlans(
    Settings asked,
    Optional<String> movement,
    NetworkSettings network,
    Catalogue catalogue,
    PrintWriter err) {
  /** The plan of a file. */
  RunPlan plan(Path file) {
    boolean zooming = asked.asked(Setting.POLICY).isPresent();
    Scenario scenario =
        asked.scenario(
            CamSimScenario.read(file, movement.orElse(null), zooming, network, catalogue, err));
    return asked
        .plan(scenario, DetectionSpec.of(asked, scenario, file, catalogue))
        .withPolicy(asked.asked(Setting.POLICY).orElse("zoom-out"));
  }
}
