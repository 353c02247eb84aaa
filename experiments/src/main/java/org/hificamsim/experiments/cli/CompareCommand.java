package org.hificamsim.experiments.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.experiments.catalogue.Catalogue;
import org.hificamsim.experiments.compare.CaseResult;
import org.hificamsim.experiments.compare.Comparison;
import org.hificamsim.experiments.compare.ComparisonRun;
import org.hificamsim.experiments.output.ManifestFile;
import org.hificamsim.experiments.run.RunExecutor;
import org.hificamsim.experiments.run.RunPlan;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code hificamsim compare}: scenarios x detection models x policies x seeds, side by side. */
@Command(
    name = "compare",
    description = "Compares policies and detection models over scenarios and seeds.",
    mixinStandardHelpOptions = true,
    showDefaultValues = true)
final class CompareCommand implements Callable<Integer> {
  private static final int MOST_STEPS = 10_000_000;
  private static final int MOST_REPEATS = 100_000;
  private static final int MOST_THREADS = 1024;

  @Parameters(arity = "1..*", paramLabel = "SCENARIO.xml", description = "The scenario files.")
  private List<Path> files;

  @Option(
      names = "--detections",
      paramLabel = "A,B",
      defaultValue = "camsim-range,hifi:orb-lin",
      description = "Detection models or model files; differences are to the first.")
  private String detections;

  @Option(
      names = "--policies",
      paramLabel = "P,Q",
      defaultValue = "zoom-out,epsilon-greedy,sarsa",
      description = "Zoom policies with their options, P:key=value,key=value,Q.")
  private String policies;

  @Option(names = "--steps", paramLabel = "N", defaultValue = "1000", description = "Steps.")
  private int steps;

  @Option(
      names = "--repeat",
      paramLabel = "N",
      defaultValue = "30",
      description = "Repeats of each case; repeat i uses seed + i.")
  private int repeats;

  @Option(names = "--seed", paramLabel = "N", defaultValue = "0", description = "First seed.")
  private long seed;

  @Option(
      names = "--out",
      paramLabel = "DIR",
      defaultValue = "out/compare",
      description = "Where the files go.")
  private Path out;

  @Option(names = "--resume", description = "Keep the runs that a killed comparison finished.")
  private boolean resume;

  @Option(
      names = "--threads",
      paramLabel = "N",
      defaultValue = "0",
      description = "Threads; 0 for one per processor. Results do not depend on it.")
  private int threads;

  @Mixin private ScenarioOptions scenarioOptions;

  @Spec private CommandSpec spec;

  @Override
  public Integer call() throws IOException {
    Instant started = Instant.now();
    Catalogue catalogue = Catalogue.load();
    List<RunPlan> plans = plans(catalogue);
    RunExecutor executor = new RunExecutor(catalogue);
    plans.forEach(executor::check);
    List<CaseResult> cases = execute(plans, executor, started);
    ComparisonTable.print(spec.commandLine().getOut(), cases, out);
    return 0;
  }

  private List<CaseResult> execute(List<RunPlan> plans, RunExecutor executor, Instant started)
      throws IOException {
    int runs = Comparison.withOptimum(plans).size() * repeats;
    try (Progress progress = new Progress("compare", " runs", runs, spec.commandLine().getErr())) {
      Comparison comparison = new Comparison(executor, threadCount(), progress::advance);
      return new ComparisonRun(comparison, resume)
          .execute(
              plans,
              out,
              (folder, results) ->
                  ManifestFile.write(
                      folder.open("manifest.json"),
                      spec.commandLine().getParent().getParseResult().originalArgs(),
                      started,
                      (long) runs * steps));
    }
  }

  private int threadCount() {
    return threads == 0 ? Runtime.getRuntime().availableProcessors() : threads;
  }

  private List<RunPlan> plans(Catalogue catalogue) {
    Numbers.inRange("--steps", steps, 1, MOST_STEPS);
    Numbers.inRange("--repeat", repeats, 1, MOST_REPEATS);
    Numbers.inRange("--threads", threads, 0, MOST_THREADS);
    List<DetectionModel> models = new ArrayList<>();
    for (String name : detections.split(",", -1)) {
      models.add(catalogue.detection(name.strip()));
    }
    requireDistinct("--detections", models.stream().map(DetectionModel::name).toList());
    List<String> specs = PolicyList.split(policies, catalogue.policies());
    requireDistinct("--policies", specs);
    List<Scenario> scenarios =
        files.stream()
            .map(file -> scenarioOptions.read(file, catalogue, spec.commandLine().getErr()))
            .toList();
    requireDistinct("the scenarios' names", scenarios.stream().map(Scenario::name).toList());
    List<RunPlan> plans = new ArrayList<>();
    for (Scenario scenario : scenarios) {
      for (DetectionModel model : models) {
        double threshold = scenario.threshold().orElse(model.defaultThreshold());
        for (String policy : specs) {
          plans.add(
              new RunPlan(scenario, new Detection(model, threshold), policy, steps, seed, repeats));
        }
      }
    }
    return plans;
  }

  private static void requireDistinct(String what, List<String> names) {
    for (int i = 0; i < names.size(); i++) {
      if (names.indexOf(names.get(i)) < i) {
        throw new InputException(what + " has '" + names.get(i) + "' twice, expected each once");
      }
    }
  }
}
