package org.hificamsim.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Ranges;
import org.hificamsim.core.Spelling;
import org.hificamsim.network.NetworkSettings;
import org.hificamsim.network.Strategy;
import org.hificamsim.network.bandit.BanditAlgorithm;
import org.hificamsim.network.files.NetworkText;
import org.hificamsim.network.study.NetworkChoice;
import org.hificamsim.network.study.NetworkSearch;
import org.hificamsim.network.study.StudyFiles;
import org.hificamsim.network.study.StudyFiles.SetFront;
import org.hificamsim.network.study.StudyGroup.Members;
import org.hificamsim.network.study.StudyPlan;
import org.hificamsim.network.study.StudyResults;
import org.hificamsim.reproduction.JudgedClaim;
import org.hificamsim.reproduction.ReproductionFiles;
import org.hificamsim.reproduction.StudyStatements;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.Setting;
import org.hificamsim.runs.output.TextTable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code hificamsim tradeoff}: CamSim's studies of utility against messages. */
@Command(
    name = "tradeoff",
    description = {
      "Compares the communication strategies of CamSim's network: utility against messages.",
      "On request also heterogeneous networks and bandits; says which are on the Pareto front."
    })
final class TradeoffCommand implements Callable<Integer> {
  private static final Pattern HETEROGENEOUS =
      Pattern.compile("none|all|(sample|search):([1-9]\\d{0,6})");

  /** The number of networks of a front that are named, by ascending cost. */
  private static final int MAX_NAMED = 6;

  @Parameters(arity = "1..*", paramLabel = "SCENARIO.xml", description = "The scenario files.")
  private List<Path> files;

  @Option(names = "--of", split = ",", paramLabel = "A0,A1,...")
  private List<String> strategies;

  @Option(names = "--heterogeneous", paramLabel = "none|all|sample:N|search:N")
  private String heterogeneous;

  @Option(names = "--bandits", split = ",", paramLabel = "none|all|A,B")
  private List<String> bandits;

  @Option(names = "--alphas", split = ",", paramLabel = "X,Y")
  private List<Double> alphas;

  @Option(names = "--camsim-files")
  private boolean camSimFiles;

  @Mixin private BatchRun batch;

  @Mixin private Screen screen;

  @Mixin
  private final SettingOptions settings =
      SettingOptions.of(
          Setting.DETECTION,
          Setting.THRESHOLD,
          Setting.DETECT,
          Setting.CHANNEL,
          Setting.STEPS,
          Setting.SEED,
          Setting.REPEAT);

  @Override
  public Integer call() throws IOException {
    Catalogue catalogue = Catalogue.load();
    NetworkChoice choice = choice();
    CamSimPlans plans =
        new CamSimPlans(
            settings.settings(),
            Optional.empty(),
            NetworkSettings.CAMSIM.withStrategies(choice.strategies().subList(0, 1)),
            catalogue,
            screen.err());
    List<RunPlan> bases = files.stream().map(plans::plan).toList();
    NameLists.requireDistinct(
        "the scenarios' names", bases.stream().map(base -> base.scenario().name()).toList());
    List<StudyPlan> networks = networks(choice, bases);
    List<RunPlan> all = networks.stream().map(StudyPlan::plan).toList();
    int searched = count("search");
    if (searched > 0 && batch.isInParts()) {
      throw new InputException(
          "--heterogeneous search has no parts: expected sample:N with --shard or --merge");
    }
    long steps =
        all.stream().mapToLong(RunPlan::work).sum()
            + bases.stream().mapToLong(base -> searched * base.work()).sum();
    return batch.execute(
        screen,
        catalogue,
        new BatchRun.Runs(all, bases, steps, false),
        (folder, engine) -> {
          StudyResults results = new StudyResults();
          results.run(networks, engine);
          if (searched > 0) {
            for (RunPlan base : bases) {
              new NetworkSearch(choice, base, results, engine).run(searched);
            }
          }
          batch.warnOfFewSeeds(bases.get(0).repeats());
          if (camSimFiles) {
            StudyFiles.writeSummaries(folder, results);
          }
          List<SetFront> fronts = StudyFiles.write(folder, results);
          List<JudgedClaim> statements =
              StudyStatements.judge(fronts.stream().map(SetFront::group).distinct().toList());
          ReproductionFiles.VERDICTS.write(folder, statements.stream());
          return out -> print(out, fronts, statements);
        });
  }

  /** The number of heterogeneous networks to sample, or to search; 0 if the method is another. */
  private int count(String method) {
    Matcher form = HETEROGENEOUS.matcher(heterogeneous);
    if (!form.matches()) {
      throw InputException.of(
          "--heterogeneous is '%s', expected none, all, sample:N or search:N with N from"
              + " 1 to 9999999",
          heterogeneous);
    }
    return method.equals(form.group(1)) ? Integer.parseInt(form.group(2)) : 0;
  }

  private NetworkChoice choice() {
    NameLists.requireDistinct("--of", strategies);
    alphas.forEach(alpha -> Ranges.within("--alphas", alpha, 0, 1));
    List<Strategy> distinct =
        strategies.stream().map(Strategy::parse).flatMap(List::stream).distinct().toList();
    return new NetworkChoice(distinct, bandits(), alphas);
  }

  private List<BanditAlgorithm> bandits() {
    return switch (String.join(",", bandits)) {
      case "none" -> List.of();
      case "all" -> List.of(BanditAlgorithm.values());
      default -> bandits.stream().map(NetworkText::bandit).toList();
    };
  }

  private List<StudyPlan> networks(NetworkChoice choice, List<RunPlan> bases) {
    List<StudyPlan> networks = new ArrayList<>();
    for (RunPlan base : bases) {
      networks.addAll(choice.homogeneous(base));
      if (heterogeneous.equals("all")) {
        networks.addAll(choice.all(base));
      } else if (count("sample") > 0) {
        networks.addAll(choice.sample(base, count("sample")));
      }
      networks.addAll(choice.bandits(base));
    }
    return networks;
  }

  private static void print(PrintWriter out, List<SetFront> fronts, List<JudgedClaim> statements) {
    TextTable table =
        new TextTable(
            4, List.of("scenario", "detection", "networks", "on the front", "hypervolume", "gain"));
    for (SetFront front : fronts) {
      int homogeneous = front.group().members(Members.HOMOGENEOUS).length;
      if (EnumSet.of(Members.STATIC, Members.ADAPTIVE, Members.ALL).contains(front.members())
          && front.group().members(front.members()).length == homogeneous) {
        continue; // the set has no networks but the homogeneous ones
      }
      RunPlan plan = front.group().plan();
      int[] members = front.group().front(front.members());
      table.row(
          List.of(
              plan.scenario().name(),
              plan.detection().name(),
              Spelling.of(front.members()),
              front.names(MAX_NAMED)
                  + (members.length > MAX_NAMED ? " and " + (members.length - MAX_NAMED) : ""),
              front.group().hypervolume(front.members()).text("%.3f"),
              front.group().gain(front.members(), Members.HOMOGENEOUS).text("%+.3f")));
    }
    table.print(out);
    statements.forEach(
        statement -> out.printf("%-15s %s%n", statement.verdict().label(), statement.text()));
  }
}
