package org.hificamsim.reproduction.network;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.runs.DetectionSpec;
import org.hificamsim.runs.RunExecutor;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.RunResult;
import org.hificamsim.runs.Setting;
import org.hificamsim.runs.Settings;

/** The runs of an experiment, all of the same number of steps. */
final class ExperimentRuns {
  private final Catalogue catalogue;
  private final int steps;

  ExperimentRuns(Catalogue catalogue, int steps) {
    this.catalogue = catalogue;
    this.steps = steps;
  }

  Scenario scenario(Path file) {
    return ScenarioReader.read(file, catalogue.movements().names()::contains, warning -> {});
  }

  RunResult run(Scenario scenario, String policy, long seed) {
    return run(scenario, Settings.NONE.with(Setting.POLICY, policy), seed);
  }

  RunResult run(Scenario scenario, Settings chosen, long seed) {
    Settings settings =
        chosen.with(Setting.STEPS, Integer.toString(steps)).with(Setting.SEED, Long.toString(seed));
    DetectionSpec spec =
        DetectionSpec.parse(settings.value(Setting.DETECTION, scenario), catalogue::detection);
    RunPlan plan = settings.plan(scenario, spec.detection(settings, scenario));
    return new RunExecutor(catalogue).repeat(plan, 0, List.of());
  }

  /** Rounds a number for a table to four decimals. */
  static double rounded(double value) {
    return Double.isNaN(value)
        ? value
        : Double.parseDouble(String.format(Locale.ROOT, "%.4f", value));
  }
}
