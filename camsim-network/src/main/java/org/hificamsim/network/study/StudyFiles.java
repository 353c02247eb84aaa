package org.hificamsim.network.study;

import java.io.IOException;
import java.io.Writer;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.network.files.SummaryRows;
import org.hificamsim.network.statistics.StepFigures;
import org.hificamsim.network.study.StudyGroup.Members;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.RunResult;
import org.hificamsim.runs.compare.ComparisonFiles;
import org.hificamsim.runs.output.Column;
import org.hificamsim.runs.output.SettingsFile;
import org.hificamsim.runs.output.Table;

/** The tables of a study. */
public final class StudyFiles {
  private static final List<Column<RunPlan>> GROUP = ComparisonFiles.CASE.subList(0, 2);

  /** One run of a network. */
  record StudyRun(StudyPlan network, RunResult result) {
    ComparisonFiles.Run asRun() {
      return ComparisonFiles.Run.alone(network.plan(), result);
    }
  }

  /** A network of a group, by its index. */
  record GroupNetwork(StudyGroup group, int network) {
    StudyPlan studyPlan() {
      return group.plans().get(network);
    }
  }

  /** The front of a set of networks of a group. */
  public record SetFront(StudyGroup group, Members members) {
    /** The labels of up to {@code most} networks on the front, by rising cost. */
    public String names(int most) {
      return Arrays.stream(group.front(members))
          .limit(most)
          .mapToObj(i -> group.plans().get(i).label())
          .collect(Collectors.joining(" "));
    }
  }

  private static final List<Column<StudyPlan>> NETWORK =
      Table.<StudyPlan>of("")
          .texts(
              "kind",
              "of `tradeoff` alone, as all that follows: `homogeneous`, `heterogeneous` or"
                  + " `bandit`",
              plan -> Spelling.of(plan.kind()))
          .texts(
              "network",
              "schedule and policy of all cameras or of each, `A0-P2`: Active, Passive,"
                  + " HistActive or HistPassive with 0 Broadcast, 1 Smooth, 2 Step, 3 Fix; of"
                  + " bandits name and alpha, `UCB1@0.5`",
              StudyPlan::label)
          .columns();

  private static final List<String> IN_RESULTS =
      ComparisonFiles.RESULTS.columns().stream().map(Column::name).toList();

  /** One row per run. */
  public static final Table<StudyRun> RESULTS =
      Table.<StudyRun>of(ComparisonFiles.RESULTS.file())
          .with(ComparisonFiles.RESULTS.columns(), StudyRun::asRun)
          .with(NETWORK, StudyRun::network)
          .with(
              StudyResults.KEPT.stream()
                  .filter(metric -> !IN_RESULTS.contains(metric.label()))
                  .flatMap(StudyFiles::metric)
                  .toList());

  /** One row per network. */
  public static final Table<GroupNetwork> NETWORKS =
      Table.<GroupNetwork>of("networks.csv")
          .with(GROUP, row -> row.group.plan())
          .with(NETWORK, GroupNetwork::studyPlan)
          .estimates(
              "utility",
              "utility_",
              "",
              "the mean over the seeds",
              row -> row.group.utility(row.network))
          .estimates(
              "cost",
              "cost_",
              "number",
              "messages that arrive; the mean over the seeds",
              row -> row.group.cost(row.network))
          .doubles(
              "utility_share",
              "share",
              "of the largest utility of the scenario's networks",
              row -> row.group.utilityShare(row.network))
          .doubles(
              "cost_share", "share", "of the largest cost", row -> row.group.costShare(row.network))
          .doubles(
              "below_front",
              "share",
              "of the largest utility, that a network of strategies that never change has more at"
                  + " no more cost; 0 on their front, below 0 beyond it",
              row -> row.group.belowFront(row.network))
          .texts(
              "option", "the setting `network` of a run", row -> row.studyPlan().plan().network());

  /** One row per scenario, detection and set of networks. */
  public static final Table<SetFront> FRONTS =
      Table.<SetFront>of("fronts.csv")
          .with(GROUP, row -> row.group.plan())
          .texts(
              "networks",
              "`homogeneous`; `static`, these and the heterogeneous ones; `bandit`; `adaptive`,"
                  + " homogeneous ones and bandits; `all`",
              row -> Spelling.of(row.members))
          .ints("count", "", "how many", row -> row.group.members(row.members).length)
          .ints("on_front", "", "how many none beats", row -> row.group.front(row.members).length)
          .estimates(
              "hypervolume",
              "hypervolume_",
              "share",
              "of the rectangle from no utility at the largest cost to the largest utility at no"
                  + " cost, that the front beats; intervals by the jackknife over seeds",
              row -> row.group.hypervolume(row.members))
          .estimates(
              "gain",
              "gain_",
              "share",
              "this less that of the homogeneous networks",
              row -> row.group.gain(row.members, Members.HOMOGENEOUS))
          .texts(
              "front",
              "the networks on it, by rising cost, up to a hundred",
              row -> row.names(100));

  private StudyFiles() {}

  /**
   * Adds {@code settings.json} and the tables to a folder's files.
   *
   * @return the fronts of all sets that are not empty
   */
  public static List<SetFront> write(OutputFolder folder, StudyResults results) throws IOException {
    List<StudyPlan> plans = results.plans();
    RESULTS.write(
        folder,
        IntStream.range(0, plans.size())
            .boxed()
            .flatMap(i -> results.runs(i).map(run -> new StudyRun(plans.get(i), run))));
    List<StudyGroup> groups = StudyGroup.of(results);
    SettingsFile.write(folder, groups.stream().map(StudyGroup::plan).toList());
    NETWORKS.write(
        folder,
        groups.stream()
            .flatMap(
                group ->
                    IntStream.range(0, group.plans().size())
                        .mapToObj(i -> new GroupNetwork(group, i))));
    List<SetFront> fronts =
        groups.stream()
            .flatMap(group -> Stream.of(Members.values()).map(set -> new SetFront(group, set)))
            .filter(row -> row.group.members(row.members).length > 0)
            .toList();
    FRONTS.write(folder, fronts.stream());
    return fronts;
  }

  /**
   * Adds a summary file for each network, with one row per seed, as CamSim's scripts read it and
   * {@code camsim --repeat} writes it.
   */
  public static void writeSummaries(OutputFolder folder, StudyResults results) throws IOException {
    for (int i = 0; i < results.plans().size(); i++) {
      StudyPlan plan = results.plans().get(i);
      String name = "summary-" + plan.plan().scenario().name() + "-" + plan.label() + ".csv";
      int steps = plan.plan().steps();
      try (Writer out = folder.open(name)) {
        out.write(
            SummaryRows.text(
                plan.plan().seed(), results.runs(i).map(run -> figures(steps, run)).toList()));
      }
    }
  }

  private static StepFigures figures(int steps, RunResult run) {
    return new StepFigures(
        steps,
        run.value(Metric.UTILITY),
        (long) run.value(Metric.MESSAGES),
        0,
        0,
        (long) run.value(Metric.INVITATIONS),
        run.value(Metric.OVERLAP),
        run.value(Metric.CONFIDENCE),
        run.value(Metric.TRACKED),
        (long) run.value(Metric.HANDOVERS));
  }

  private static Stream<Column<StudyRun>> metric(Metric metric) {
    return Table.<StudyRun>of("")
        .plain(metric, (row, column) -> row.result.value(column))
        .columns()
        .stream();
  }
}
