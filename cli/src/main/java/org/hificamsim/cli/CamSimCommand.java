package org.hificamsim.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.OutputFile;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioWriter;
import org.hificamsim.network.NetworkRun;
import org.hificamsim.network.NetworkSettings;
import org.hificamsim.network.ScenarioForCamSim;
import org.hificamsim.network.files.CamSimFiles;
import org.hificamsim.network.statistics.StepFigures;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.Setting;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code hificamsim camsim}: CamSim's command line, with CamSim's files and numbers. */
@Command(
    name = "camsim",
    description = {
      "Runs scenarios as CamSim does, with auctions and handovers, and writes CamSim's files.",
      "With --policy cameras use the zoom levels of the file, which CamSim ignores."
    })
final class CamSimCommand implements Callable<Integer> {
  /** The default of CamSim. */
  private static final int DEFAULT_STEPS = 100;

  @Parameters(arity = "1..*", paramLabel = "SCENARIO.xml", description = "The scenario files.")
  private List<Path> files;

  @Option(
      names = {"-o", "--output"},
      paramLabel = "FILE")
  private Path output;

  @Option(
      names = {"-f", "--summaryfile"},
      paramLabel = "FILE")
  private Optional<Path> summary;

  @Option(
      names = {"-s", "--seed"},
      paramLabel = "N")
  private int seed;

  @Option(names = "--repeat", paramLabel = "N")
  private int repeat;

  @Option(
      names = {"-t", "--time"},
      paramLabel = "N")
  private Optional<Integer> steps;

  @Option(
      names = {"-m", "--movement"},
      paramLabel = "CLASS")
  private Optional<String> movement;

  @Option(names = "--no-gui")
  @SuppressWarnings("UnusedVariable") // accepted for compatibility with CamSim
  private boolean noGui;

  @Mixin private CamSimOptions options;

  @Option(names = "--coverage-out", paramLabel = "DIR")
  private Optional<Path> coverage;

  @Option(names = "--for-camsim", paramLabel = "FILE")
  private Optional<Path> forCamSim;

  @Mixin private Destination destination;

  @Mixin private Screen screen;

  @Mixin
  private final SettingOptions settings =
      SettingOptions.of(
              Setting.DETECTION, Setting.THRESHOLD, Setting.DETECT, Setting.POLICY, Setting.CHANNEL)
          .withoutDefault(Setting.POLICY);

  @Override
  public Integer call() throws IOException {
    return forCamSim.isPresent() ? writeForCamSim(forCamSim.get()) : run();
  }

  private int writeForCamSim(Path to) throws IOException {
    OutputFile target = destination.inFolder("--for-camsim", to);
    if (files.size() > 1) {
      throw new InputException("--for-camsim has " + files.size() + " scenarios, expected one");
    }
    CamSimPlans plans = plans(options.settings(screen.err()), Catalogue.load());
    target.write(ScenarioWriter.write(ScenarioForCamSim.of(plans.plan(files.get(0)).scenario())));
    screen.out().println(to);
    return 0;
  }

  private int run() throws IOException {
    Catalogue catalogue = Catalogue.load();
    NetworkSettings network = options.settings(screen.err());
    CamSimPlans plans = plans(network, catalogue);
    steps.ifPresent(number -> Numbers.inRange("-t", number, 0, Scenario.MAX_STEPS));
    Numbers.inRange("--repeat", repeat, 1, Integer.MAX_VALUE - Math.max(0, seed));
    List<RunPlan> bases = files.stream().map(plans::plan).toList();
    NameLists.requireDistinct(
        "the scenarios' names", bases.stream().map(base -> base.scenario().name()).toList());
    for (int i = 0; i < bases.size(); i++) {
      for (int run = 0; run < repeat; run++) {
        run(files.get(i), plan(bases.get(i), seed + run), network, catalogue);
      }
    }
    return 0;
  }

  private CamSimPlans plans(NetworkSettings network, Catalogue catalogue) {
    return new CamSimPlans(settings.settings(), movement, network, catalogue, screen.err());
  }

  private RunPlan plan(RunPlan base, int runSeed) {
    int stepsOfRun = steps.or(() -> base.scenario().find(Scenario.STEPS)).orElse(DEFAULT_STEPS);
    return new RunPlan(base.scenario(), base.detection(), base.policy(), stepsOfRun, runSeed, 1);
  }

  private void run(Path file, RunPlan plan, NetworkSettings network, Catalogue catalogue)
      throws IOException {
    Instant started = Instant.now();
    NetworkRun run = NetworkRun.of(plan, network, catalogue);
    CamSimFiles.Places places = places(file, plan);
    try (CamSimFiles written = new CamSimFiles(places, plan, run);
        Progress progress = screen.progress(plan.scenario().name(), " steps", plan.steps())) {
      run.listen((view, measured) -> progress.advance()).run(plan.steps());
      written.commit(screen.words(), started);
      print(plan, places.output(), run.sums());
    }
  }

  private CamSimFiles.Places places(Path file, RunPlan plan) throws IOException {
    boolean hasSeveralRuns = files.size() > 1 || repeat > 1;
    String scenarioSuffix = hasSeveralRuns ? "-" + plan.scenario().name() : "";
    String runSuffix = hasSeveralRuns ? scenarioSuffix + "-" + plan.seed() : "";
    Path steps = withSuffix(output, runSuffix);
    Optional<Path> sums =
        hasSeveralRuns
            ? Optional.of(
                withSuffix(summary.orElse(output.resolveSibling("summary.csv")), scenarioSuffix))
            : summary;
    destination.requireNoInput("-o", steps);
    destination.requireNoInput("-f", sums.orElse(steps));
    Optional<Path> covered =
        coverage.map(path -> path.resolveSibling(path.getFileName() + runSuffix));
    return new CamSimFiles.Places(file, steps, sums, covered);
  }

  /** Adds a suffix to a path, before the ending of its file name. */
  private static Path withSuffix(Path path, String suffix) {
    String name = path.getFileName().toString();
    int dot = name.lastIndexOf('.') < 1 ? name.length() : name.lastIndexOf('.');
    return path.resolveSibling(name.substring(0, dot) + suffix + name.substring(dot));
  }

  private void print(RunPlan plan, Path to, StepFigures sums) {
    screen.say(
        "%s: %d steps, seed %d: utility %.4f, %d messages, %d handovers, %.4f tracked; %s",
        plan.scenario().name(),
        plan.steps(),
        plan.seed(),
        sums.utility(),
        sums.communication(),
        sums.handovers(),
        sums.meanProportion(),
        to);
  }
}
