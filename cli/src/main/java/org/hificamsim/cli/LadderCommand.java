package org.hificamsim.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.reproduction.ladder.Ladder;
import org.hificamsim.reproduction.ladder.LadderFiles;
import org.hificamsim.reproduction.ladder.Rung;
import org.hificamsim.reproduction.ladder.Rungs;
import org.hificamsim.reproduction.ladder.WorldRungs;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.Setting;
import org.hificamsim.runs.Settings;
import org.hificamsim.runs.compare.ComparisonFiles;
import org.hificamsim.runs.compare.ReferencePolicies;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code hificamsim ladder}: how much realism the choice of a policy needs. */
@Command(
    name = "ladder",
    description = {
      "Chooses a policy by each rung of realism, and judges the choices by the top rung:",
      "predicted score, order of the policies, what the choice costs, what a step costs."
    })
final class LadderCommand implements Callable<Integer> {
  /** What rises from rung to rung. */
  private enum Of {
    DETECTION,
    WORLD
  }

  @Parameters(arity = "1..*", paramLabel = "SCENARIO.xml", description = "The scenario files.")
  private List<Path> files;

  @Option(
      names = "--of",
      paramLabel = "detection|world",
      description =
          "What rises from rung to rung: the detection model, or lenses, pan, time, walls and"
              + " occlusion.")
  private String of;

  @Option(
      names = "--rungs",
      paramLabel = "A,B[@T]",
      description =
          "Detection models or model files, perhaps with thresholds or rules, the top rung last;"
              + " with --of world names of its rungs. Default: those of docs/ladder.md.")
  private Optional<String> rungs;

  @Option(
      names = "--detection",
      paramLabel = "NAME|FILE.json[@T|@RULE]",
      description =
          "With --of world: what all rungs detect by; default: " + WorldRungs.DETECTION + ".")
  private Optional<String> detection;

  @Option(
      names = "--policies",
      paramLabel = "P,Q",
      description = "Zoom policies to choose from, P:key=value,key=value,Q.")
  private String policies;

  @Mixin private ScenarioOptions scenarioOptions;

  @Mixin private BatchOptions batch;

  @Mixin private Screen screen;

  @Mixin
  private final SettingOptions settings = SettingOptions.allBut(Setting.DETECTION, Setting.POLICY);

  @Override
  public Integer call() throws IOException {
    Catalogue catalogue = Catalogue.load();
    Settings asked = settings.settings();
    Ladder ladder = ladder(asked, catalogue);
    List<RunPlan> plans = ladder.plans(asked);
    return new BatchRun(screen, batch, catalogue, ReferencePolicies.OPTIMUM)
        .execute(
            plans,
            (folder, results) -> {
              ComparisonFiles.write(folder, results.subList(0, plans.size()), results);
              return LadderFiles.write(folder, ladder, results, catalogue);
            },
            LadderTable::print);
  }

  private Ladder ladder(Settings asked, Catalogue catalogue) {
    asked.asked(Setting.DETECT).ifPresent(LadderCommand::refuse);
    List<String> specs = PolicyList.split(policies, catalogue.policies());
    Distinct.require("--policies", specs);
    List<Scenario> scenarios = scenarioOptions.read(files, asked, catalogue, screen.err());
    return new Ladder(
        scenarios,
        rungsAsked(),
        specs,
        (rung, scenario) -> rung.spec(catalogue::detection).detection(asked, scenario));
  }

  private static void refuse(String rule) {
    throw new InputException(
        "--detect is '" + rule + "', expected none: a rung names its own, --rungs NAME@" + rule);
  }

  private List<Rung> rungsAsked() {
    Optional<List<String>> names =
        rungs.map(text -> Arrays.stream(text.split(",", -1)).map(String::strip).toList());
    return Spelling.require(Of.class, "--of", of) == Of.WORLD ? ofWorld(names) : ofDetection(names);
  }

  private List<Rung> ofWorld(Optional<List<String>> names) {
    WorldRungs all = new WorldRungs(detection.orElse(WorldRungs.DETECTION));
    return names.map(asked -> asked.stream().map(all::named).toList()).orElseGet(all::all);
  }

  private List<Rung> ofDetection(Optional<List<String>> names) {
    detection.ifPresent(
        text -> {
          throw new InputException(
              "--detection is '"
                  + text
                  + "', expected none without --of world: --rungs names them");
        });
    return names.map(asked -> asked.stream().map(Rungs::named).toList()).orElseGet(Rungs::all);
  }
}
