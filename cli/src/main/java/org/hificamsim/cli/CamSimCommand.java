package org.hificamsim.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.GeometricDetection;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.world.World;
import org.hificamsim.network.CamSimScenario;
import org.hificamsim.network.Network;
import org.hificamsim.network.NetworkSettings;
import org.hificamsim.network.files.CamSimFiles;
import org.hificamsim.network.files.RunSums;
import org.hificamsim.runs.RunPlan;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code hificamsim camsim}: CamSim's command line, with CamSim's files and numbers. */
@Command(
    name = "camsim",
    description = "Runs a scenario as CamSim does, network and all, and writes CamSim's files.",
    mixinStandardHelpOptions = true)
final class CamSimCommand implements Callable<Integer> {
  private static final int MAX_STEPS = 1_000_000_000;

  @Parameters(paramLabel = "SCENARIO.xml", description = "The scenario file.")
  private Path file;

  @Option(
      names = {"-o", "--output"},
      paramLabel = "FILE",
      defaultValue = "output.csv",
      description = "The table of steps; default: ${DEFAULT-VALUE}.")
  private Path output;

  @Option(
      names = {"-f", "--summaryfile"},
      paramLabel = "FILE",
      description = "The summary, appended to; default: summary.csv beside the output.")
  private Path summary;

  @Option(
      names = {"-s", "--seed"},
      paramLabel = "N",
      defaultValue = "0",
      description = "Seed; default: ${DEFAULT-VALUE}.")
  private int seed;

  @Option(
      names = {"-t", "--time"},
      paramLabel = "N",
      defaultValue = "100",
      description = "Steps; default: ${DEFAULT-VALUE}.")
  private int steps;

  @Option(
      names = {"-m", "--movement"},
      paramLabel = "CLASS",
      description = "Movement of all objects.")
  private String movement;

  @Option(names = "--no-gui", description = "Understood; there is no window here.")
  @SuppressWarnings("UnusedVariable") // understood for CamSim's sake
  private boolean noGui;

  @Mixin private CamSimOptions options;

  @Option(
      names = "--detection",
      paramLabel = "NAME|FILE.json",
      defaultValue = "camsim-visibility",
      description =
          "Where confidences come from; default: ${DEFAULT-VALUE}. See 'list detections'.")
  private String detection;

  @Option(
      names = "--threshold",
      paramLabel = "T",
      description = "Detection threshold, 0 to 1; default: the scenario's, else the model's.")
  private Double threshold;

  @Option(
      names = "--policy",
      paramLabel = "NAME[:key=value,...]",
      description = "Zoom policy over the file's zoom list, which CamSim ignores.")
  private String policy;

  @Option(
      names = "--extra-out",
      paramLabel = "FILE",
      description = "Table of cameras that see anything, true overlap area, and handovers.")
  private Path extra;

  @Option(
      names = "--coverage-out",
      paramLabel = "DIR",
      description = "k-coverage of the same run: steps.csv, summary.json, manifest.json.")
  private Path coverage;

  @Spec private CommandSpec spec;

  @Override
  public Integer call() throws IOException {
    Instant started = Instant.now();
    PrintWriter err = spec.commandLine().getErr();
    Catalogue catalogue = Catalogue.load();
    NetworkSettings settings = options.settings(err);
    RunPlan plan = plan(catalogue, settings, err);
    World world = new World(plan.scenario(), catalogue.movements(), seed);
    Network network = new Network(world, plan.detection(), settings, seed);
    ZoomPolicy zooms = catalogue.policies().create(plan.policy());
    CamSimFiles.Places places =
        new CamSimFiles.Places(output, Optional.ofNullable(summary), extra(), coverage());
    try (CamSimFiles files = new CamSimFiles(places, plan, world, network);
        Progress progress =
            new Progress("camsim " + plan.scenario().name(), " steps", steps, err)) {
      List<StepListener> listeners = new ArrayList<>(files.listeners());
      listeners.add((view, measured) -> progress.advance());
      new Simulation(world, observed(plan), zooms, network, seed, listeners).run(steps);
      files.commit(spec.commandLine().getParent().getParseResult().originalArgs(), started);
      print(plan.scenario(), files.sums());
    }
    return 0;
  }

  /** The loop's own observation: where nobody reads its coverage, the cheapest will do. */
  private Detection observed(RunPlan plan) {
    return coverage == null && policy == null
        ? Detection.of(new GeometricDetection())
        : plan.detection();
  }

  private Optional<Path> extra() {
    return Optional.ofNullable(extra);
  }

  private Optional<Path> coverage() {
    return Optional.ofNullable(coverage);
  }

  /** Checks every option before anything is written. */
  private RunPlan plan(Catalogue catalogue, NetworkSettings settings, PrintWriter err) {
    Numbers.inRange("-t", steps, 0, MAX_STEPS);
    if (threshold != null) {
      Numbers.proportion("--threshold", threshold);
    }
    DetectionModel model = catalogue.detection(detection);
    Scenario scenario =
        CamSimScenario.read(file, movement, policy != null, settings, catalogue, err);
    double tau =
        threshold != null ? threshold : scenario.threshold().orElse(model.defaultThreshold());
    String zooms = policy == null ? "zoom-out" : policy;
    return new RunPlan(scenario, new Detection(model, tau), zooms, steps, seed, 1);
  }

  private void print(Scenario scenario, RunSums sums) {
    PrintWriter out = spec.commandLine().getOut();
    out.printf(
        Locale.ROOT,
        "%s: %d steps, seed %d: utility %.4f, %d messages, %d handovers, %.4f tracked; %s%n",
        scenario.name(),
        steps,
        seed,
        sums.utility(),
        sums.communication(),
        sums.handovers(),
        sums.meanProportion(),
        output);
    out.flush();
  }
}
