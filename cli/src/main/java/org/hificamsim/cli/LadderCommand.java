package org.hificamsim.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.Texts;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.reproduction.ladder.Ladder;
import org.hificamsim.reproduction.ladder.LadderFiles;
import org.hificamsim.reproduction.ladder.LadderResult;
import org.hificamsim.reproduction.ladder.LadderResult.RungResult;
import org.hificamsim.reproduction.ladder.Rungs;
import org.hificamsim.reproduction.ladder.Rungs.Rung;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.Setting;
import org.hificamsim.runs.Settings;
import org.hificamsim.runs.compare.ComparisonFiles;
import org.hificamsim.runs.compare.ReferencePolicies;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code hificamsim ladder}: shows how much realism the choice of a policy needs. */
@Command(
    name = "ladder",
    description = {
      "Shows how much realism you need to choose the right policy.",
      "For each rung of realism: predicted scores, order of policies, loss by its choice, time."
    })
final class LadderCommand implements Callable<Integer> {
  /** The part that becomes more realistic from rung to rung. */
  private enum LadderKind {
    DETECTION,
    WORLD
  }

  @Parameters(arity = "1..*", paramLabel = "SCENARIO.xml", description = "The scenario files.")
  private List<Path> files;

  @Option(names = "--of", paramLabel = "detection|world")
  private String kind;

  @Option(names = "--rungs", paramLabel = "A,B[@T]")
  private Optional<String> rungs;

  @Option(
      names = "--detection",
      paramLabel = "NAME|FILE.json[@T|@RULE]",
      description =
          "With --of world: the detection of all rungs; default: the scenario's, else "
              + Rungs.WORLD_DETECTION
              + ".")
  private Optional<String> detection;

  @Option(names = "--policies", paramLabel = "P,Q")
  private String policies;

  @Mixin private ScenarioOptions scenarioOptions;

  @Mixin private BatchRun batch;

  @Mixin private Screen screen;

  @Mixin
  private final SettingOptions settings =
      SettingOptions.allBut(Setting.DETECTION, Setting.POLICY, Setting.NETWORK);

  @Override
  public Integer call() throws IOException {
    Catalogue catalogue = Catalogue.load();
    Settings asked = settings.settings();
    Ladder ladder = ladder(asked, catalogue);
    List<RunPlan> plans = ladder.plans(asked);
    warnAbout(plans, catalogue);
    return batch.execute(
        screen,
        catalogue,
        ReferencePolicies.OPTIMUM,
        plans,
        (folder, results) -> {
          ComparisonFiles.write(folder, results.subList(0, plans.size()), results);
          LadderResult result = LadderFiles.write(folder, ladder, results, catalogue);
          return out -> print(out, result);
        });
  }

  /** Warns if the detection of a rung does not suit a scenario. */
  private void warnAbout(List<RunPlan> plans, Catalogue catalogue) {
    String first = plans.get(0).policy();
    plans.stream()
        .filter(plan -> plan.policy().equals(first))
        .forEach(
            plan ->
                scenarioOptions.warnAbout(
                    Path.of(plan.scenario().name()),
                    plan.scenario(),
                    plan.detection(),
                    catalogue,
                    screen.err()));
  }

  private Ladder ladder(Settings asked, Catalogue catalogue) {
    asked.asked(Setting.DETECT).ifPresent(LadderCommand::rejectRule);
    List<String> specs = NameLists.policies(policies, catalogue.policies());
    List<Scenario> scenarios = scenarioOptions.read(files, asked, catalogue, screen.err());
    return new Ladder(
        scenarios,
        rungs(),
        specs,
        (rung, scenario) -> rung.detection(asked, scenario, catalogue::detection));
  }

  private static void rejectRule(String rule) {
    throw InputException.of(
        "--detect is '%s', expected none: a rung names its own, --rungs NAME@%s", rule, rule);
  }

  private List<Rung> rungs() {
    Optional<List<String>> names =
        rungs.map(text -> Arrays.stream(text.split(",", -1)).map(String::strip).toList());
    return Spelling.require(LadderKind.class, "--of", kind) == LadderKind.WORLD
        ? worldRungs(names)
        : detectionRungs(names);
  }

  private List<Rung> worldRungs(Optional<List<String>> names) {
    return names
        .map(list -> list.stream().map(name -> Rungs.ofWorld(detection, name)).toList())
        .orElseGet(() -> Rungs.ofWorld(detection));
  }

  private List<Rung> detectionRungs(Optional<List<String>> names) {
    detection.ifPresent(
        text -> {
          throw InputException.of(
              "--detection is '%s', expected none without --of world: --rungs names them", text);
        });
    return names
        .map(list -> list.stream().map(Rungs::ofDetection).toList())
        .orElseGet(Rungs::ofDetection);
  }

  /** Prints each scenario, then all scenarios together with the costs. */
  private static void print(PrintWriter out, LadderResult result) {
    String columns =
        "%-"
            + width(result.scenarios().stream())
            + "s  %-"
            + width(result.rungs().stream().map(row -> row.rung().name()))
            + "s  %7s  %20s  %23s  ";
    String loss = result.measure() + " lost, % [95%]";
    String header = columns.formatted("scenario", "rung", "optimum", "tau [95%]", loss);
    out.println(header + "chosen");
    for (RungResult row : result.rungs()) {
      if (!row.scenario().equals(RungResult.ALL)) {
        out.println(line(columns, row) + String.join(LadderFiles.OR, row.chosen()));
      }
    }
    out.println();
    out.println(header + " ns/step  adds");
    List<RungResult> all = result.inScenario(RungResult.ALL);
    for (int i = 0; i < all.size(); i++) {
      String cost = Texts.format("%8.0f  ", result.nanoseconds().get(i));
      out.println(line(columns, all.get(i)) + cost + all.get(i).rung().adds());
    }
  }

  private static String line(String columns, RungResult row) {
    return columns.formatted(
        row.scenario(),
        row.rung().name(),
        Texts.format("%.3f", row.optimum().mean()),
        row.tau().text("%.2f"),
        row.share().times(100).text("%.1f"));
  }

  private static int width(Stream<String> texts) {
    return texts.mapToInt(String::length).reduce(8, Math::max);
  }
}
