package org.hificamsim.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.reproduction.ladder.Ladder;
import org.hificamsim.reproduction.ladder.LadderFiles;
import org.hificamsim.reproduction.ladder.LadderResult;
import org.hificamsim.reproduction.ladder.Rung;
import org.hificamsim.reproduction.ladder.Rungs;
import org.hificamsim.runs.compare.ComparisonRun;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code hificamsim ladder}: how much realism the choice of a policy needs. */
@Command(
    name = "ladder",
    description = {
      "Chooses a policy by each rung of realism, and judges the choices by the top rung:",
      "predicted k_min, order of the policies, what the choice costs, what a step costs."
    })
final class LadderCommand implements Callable<Integer> {
  @Parameters(arity = "1..*", paramLabel = "SCENARIO.xml", description = "The scenario files.")
  private List<Path> files;

  @Option(
      names = "--rungs",
      paramLabel = "A,B[@T]",
      description =
          "Detection models or model files, perhaps with thresholds or rules, the top rung last;"
              + " default: those of docs/ladder.md.")
  private Optional<String> rungs;

  @Option(
      names = "--policies",
      paramLabel = "P,Q",
      description = "Zoom policies to choose from, P:key=value,key=value,Q.")
  private String policies;

  @Mixin private ScenarioOptions scenarioOptions;

  @Mixin private BatchOptions batch;

  @Mixin private Screen screen;

  private LadderResult result;

  @Override
  public Integer call() throws IOException {
    Catalogue catalogue = Catalogue.load();
    Ladder ladder = ladder(catalogue);
    RepeatOptions repeats = batch.repeats();
    return new BatchRun(screen, batch, catalogue)
        .execute(
            ladder.plans(repeats.steps(), repeats.seed(), repeats.repeats()),
            ComparisonRun::execute,
            (folder, results) -> result = LadderFiles.write(folder, ladder, results, catalogue),
            (out, results) -> LadderTable.print(out, result));
  }

  private Ladder ladder(Catalogue catalogue) {
    scenarioOptions.rule().ifPresent(rule -> refuse(rule.text()));
    List<String> specs = PolicyList.split(policies, catalogue.policies());
    Distinct.require("--policies", specs);
    List<Scenario> scenarios =
        files.stream().map(file -> scenarioOptions.read(file, catalogue, screen.err())).toList();
    scenarios.forEach(LadderCommand::requireKMin);
    Distinct.require("the scenarios' names", scenarios.stream().map(Scenario::name).toList());
    return new Ladder(
        scenarios,
        asked(),
        specs,
        (rung, scenario) -> scenarioOptions.detection(rung.spec(catalogue::detection), scenario));
  }

  private static void requireKMin(Scenario scenario) {
    if (!scenario.objective().isKMin()) {
      throw new InputException(
          "the objective of '"
              + scenario.name()
              + "' is "
              + scenario.objective().text()
              + ", expected kmin, by which rungs are judged. Maybe give --objective kmin");
    }
  }

  private static void refuse(String rule) {
    throw new InputException(
        "--detect is '" + rule + "', expected none: a rung names its own, --rungs NAME@" + rule);
  }

  private List<Rung> asked() {
    return rungs.isEmpty()
        ? Rungs.all()
        : Arrays.stream(rungs.get().split(",", -1)).map(name -> Rungs.named(name.strip())).toList();
  }
}
