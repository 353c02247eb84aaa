package org.hificamsim.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Instant;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.file.OutputFile;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioWriter;
import org.hificamsim.network.CamSimScenario;
import org.hificamsim.network.NetworkRun;
import org.hificamsim.network.NetworkSettings;
import org.hificamsim.network.StandingObjects;
import org.hificamsim.network.files.CamSimFiles;
import org.hificamsim.network.statistics.StepFigures;
import org.hificamsim.runs.DetectionSpec;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.Setting;
import org.hificamsim.runs.Settings;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code hificamsim camsim}: CamSim's command line, with CamSim's files and numbers. */
@Command(
    name = "camsim",
    description = {
      "Runs a scenario as CamSim does, network and all, and writes CamSim's files.",
      "A --policy zooms over the file's zoom list, which CamSim ignores."
    })
final class CamSimCommand implements Callable<Integer> {
  /** CamSim's own default. */
  private static final int USUAL_STEPS = 100;

  @Parameters(paramLabel = "SCENARIO.xml", description = "The scenario file.")
  private Path file;

  @Option(
      names = {"-o", "--output"},
      paramLabel = "FILE",
      description = "The table of steps.")
  private Path output;

  @Option(
      names = {"-f", "--summaryfile"},
      paramLabel = "FILE",
      description = "The summary, appended to; default: summary.csv beside the output.")
  private Optional<Path> summary;

  @Option(
      names = {"-s", "--seed"},
      paramLabel = "N",
      description = "Seed.")
  private int seed;

  @Option(
      names = {"-t", "--time"},
      paramLabel = "N",
      description = "Steps; default: the scenario's, else 100.")
  private Optional<Integer> steps;

  @Option(
      names = {"-m", "--movement"},
      paramLabel = "CLASS",
      description = "Movement of all objects.")
  private Optional<String> movement;

  @Option(names = "--no-gui", description = "Understood; there is no window here.")
  @SuppressWarnings("UnusedVariable") // understood for CamSim's sake
  private boolean noGui;

  @Mixin private CamSimOptions options;

  @Option(
      names = "--extra-out",
      paramLabel = "FILE",
      description = "Table of cameras that see anything, true overlap area, and handovers.")
  private Optional<Path> extra;

  @Option(
      names = "--coverage-out",
      paramLabel = "DIR",
      description = "k-coverage of the same run: steps.csv, summary.json, manifest.json.")
  private Optional<Path> coverage;

  @Option(
      names = "--for-camsim",
      paramLabel = "FILE",
      description = {
        "Runs nothing, and writes the scenario as CamSim itself reads it: who follows a",
        "track comes and goes by events, and the bridge's option tracks moves it."
      })
  private Optional<Path> forCamSim;

  @Mixin private Destination destination;

  @Mixin private Screen screen;

  @Mixin
  private final SettingOptions settings =
      SettingOptions.of(
              Setting.DETECTION, Setting.THRESHOLD, Setting.DETECT, Setting.POLICY, Setting.CHANNEL)
          .open(Setting.POLICY);

  @Override
  public Integer call() throws IOException {
    return forCamSim.isPresent() ? write(forCamSim.get()) : run();
  }

  private int write(Path to) throws IOException {
    OutputFile target = destination.inFolder("--for-camsim", to);
    Catalogue catalogue = Catalogue.load();
    Scenario scenario =
        StandingObjects.of(plan(catalogue, options.settings(screen.err())).scenario());
    target.write(ScenarioWriter.write(scenario));
    screen.out().println(to);
    return 0;
  }

  private int run() throws IOException {
    Instant started = Instant.now();
    Catalogue catalogue = Catalogue.load();
    NetworkSettings camSims = options.settings(screen.err());
    RunPlan plan = plan(catalogue, camSims);
    NetworkRun run = NetworkRun.of(plan, camSims, catalogue);
    CamSimFiles.Places places = places();
    try (CamSimFiles files = new CamSimFiles(places, plan, run);
        Progress progress = screen.progress(plan.scenario().name(), " steps", plan.steps())) {
      run.listen((view, measured) -> progress.advance()).run(plan.steps());
      files.commit(screen.words(), started);
      print(plan, run.sums());
    }
    return 0;
  }

  private CamSimFiles.Places places() throws IOException {
    destination.requireNoInput("-o", output);
    destination.requireNoInput("-f", summary.orElse(output));
    if (extra.isPresent()) {
      destination.file("--extra-out", extra.get());
    }
    return new CamSimFiles.Places(file, output, summary, extra, coverage, destination.force());
  }

  /** Checks every option before anything is written. */
  private RunPlan plan(Catalogue catalogue, NetworkSettings camSims) {
    steps.ifPresent(asked -> Numbers.inRange("-t", asked, 0, Scenario.MAX_STEPS));
    Settings asked = settings.settings();
    Scenario scenario =
        asked.scenario(
            CamSimScenario.read(
                file,
                movement.orElse(null),
                asked.asked(Setting.POLICY).isPresent(),
                camSims,
                catalogue,
                screen.err()));
    return new RunPlan(
        scenario,
        DetectionSpec.of(asked, scenario, file, catalogue),
        asked.asked(Setting.POLICY).orElse("zoom-out"),
        steps.or(() -> scenario.find(Scenario.STEPS)).orElse(USUAL_STEPS),
        seed,
        1);
  }

  private void print(RunPlan plan, StepFigures sums) {
    screen
        .out()
        .printf(
            Locale.ROOT,
            "%s: %d steps, seed %d: utility %.4f, %d messages, %d handovers, %.4f tracked; %s%n",
            plan.scenario().name(),
            plan.steps(),
            seed,
            sums.utility(),
            sums.communication(),
            sums.handovers(),
            sums.meanProportion(),
            output);
  }
}
