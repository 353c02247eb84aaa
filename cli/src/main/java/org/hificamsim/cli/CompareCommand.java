package org.hificamsim.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.presentation.figures.ComparisonFigures;
import org.hificamsim.runs.DetectionSpec;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.compare.CaseResult;
import org.hificamsim.runs.compare.ComparisonRun;
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
  @Parameters(arity = "1..*", paramLabel = "SCENARIO.xml", description = "The scenario files.")
  private List<Path> files;

  @Option(
      names = "--detections",
      paramLabel = "A,B",
      defaultValue = "camsim-range,hifi:orb-lin",
      description =
          "Detection models or model files, each perhaps with @T; differences are to the first.")
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

  @Option(
      names = "--out",
      paramLabel = "DIR",
      defaultValue = "out/compare",
      description = "Where the files go.")
  private Path out;

  @Mixin private BatchOptions batch;

  @Mixin private ScenarioOptions scenarioOptions;

  @Spec private CommandSpec spec;

  @Override
  public Integer call() throws IOException {
    Catalogue catalogue = Catalogue.load();
    Optional<List<CaseResult>> cases =
        new BatchRun(spec, batch, catalogue)
            .execute(plans(catalogue), out, ComparisonRun::execute, ComparisonFigures::write);
    if (cases.isPresent()) {
      ComparisonTable.print(batch.quiet().out(spec), cases.get(), out);
    }
    return 0;
  }

  private List<RunPlan> plans(Catalogue catalogue) {
    batch.check(steps, repeats);
    List<DetectionSpec> asked =
        Arrays.stream(detections.split(",", -1))
            .map(name -> DetectionSpec.parse(name.strip(), catalogue::detection))
            .toList();
    requireDistinct("--detections", asked.stream().map(DetectionSpec::name).toList());
    List<String> specs = PolicyList.split(policies, catalogue.policies());
    requireDistinct("--policies", specs);
    List<Scenario> scenarios =
        files.stream()
            .map(file -> scenarioOptions.read(file, catalogue, batch.quiet().err(spec)))
            .toList();
    requireDistinct("the scenarios' names", scenarios.stream().map(Scenario::name).toList());
    List<RunPlan> plans = new ArrayList<>();
    for (Scenario scenario : scenarios) {
      for (DetectionSpec one : asked) {
        Detection detection = scenarioOptions.detection(one, scenario);
        for (String policy : specs) {
          plans.add(new RunPlan(scenario, detection, policy, steps, batch.seed(), repeats));
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
