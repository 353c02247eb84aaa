package org.hificamsim.runs.compare;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.RunResult;
import org.hificamsim.runs.ScoredRun;
import org.hificamsim.runs.output.Column;
import org.hificamsim.runs.output.SettingsFile;
import org.hificamsim.runs.output.Table;

/** The tables of all cases of a comparison: what {@code compare} and others like it write. */
public final class ComparisonFiles {
  /** Which case a row is about. */
  public static final List<Column<RunPlan>> CASE =
      Table.<RunPlan>of("")
          .texts(
              "scenario",
              "the scenario file's name without its ending",
              plan -> plan.scenario().name())
          .texts("detection", "the detection's name", plan -> plan.detection().name())
          .texts("policy", "the zoom policy with its options", RunPlan::policy)
          .columns();

  /** One run of a plan. */
  public record Run(RunPlan plan, CaseResult of, ScoredRun run) {
    /** A run without any yardstick. */
    public static Run alone(RunPlan plan, RunResult result) {
      return new Run(plan, null, new ScoredRun(result, Double.NaN, Double.NaN, Double.NaN));
    }

    double value(Metric metric) {
      return run.value(metric);
    }
  }

  /** One metric of a run. */
  record RunMetric(Run run, Metric metric) {}

  /**
   * One metric of a case.
   *
   * @param runs how many have a value
   * @param reference the same under the first detection model; empty for itself
   */
  record CaseMetric(
      CaseResult of,
      Metric metric,
      int runs,
      Estimate mean,
      Optional<CaseResult> reference,
      Estimate difference) {
    static CaseMetric of(CaseResult one, Metric metric, List<CaseResult> cases) {
      double[] figures = one.figures(metric);
      Optional<CaseResult> reference = firstDetection(one, cases);
      Estimate difference =
          reference
              .map(other -> Estimate.difference(figures, other.figures(metric)))
              .orElse(Estimate.single(Double.NaN));
      int runs = Estimate.known(figures).length;
      return new CaseMetric(one, metric, runs, Estimate.mean(figures), reference, difference);
    }
  }

  /** What a yardstick came to with a run. */
  record Measure(Run run, Yardstick yardstick) {}

  /** One step of a case. */
  record CaseStep(CaseResult of, int step) {}

  private static final String SEED = "the run's seed: first seed + repeat";
  private static final List<Column<Run>> RUN =
      Table.<Run>of("")
          .with(CASE, Run::plan)
          .longs("seed", "", SEED, run -> run.run.result().seed())
          .columns();

  /** A row per run that was asked for. */
  public static final Table<Run> RESULTS =
      Table.<Run>of("results.csv")
          .with(RUN)
          .plain(Metric.PERFORMANCE, Run::value)
          .doubles(Metric.PROPORTION_OF_OPTIMAL, Run::value)
          .doubles(Metric.COVERED_0, Run::value)
          .doubles(Metric.COVERED_1, Run::value)
          .doubles(Metric.COVERED_K, Run::value)
          .plain(
              "optimum",
              "that of `score`",
              "the optimum's score, which the proportion is of; empty where it is no yardstick",
              run -> run.run.optimum())
          .texts(
              "objective",
              "what a step is scored by ([objectives](objectives.md))",
              run -> run.plan().objective().text())
          .plain(Metric.SCORE, Run::value);

  /** A row per scenario, detection, yardstick and seed. */
  public static final Table<Measure> YARDSTICKS =
      Table.<Measure>of("yardsticks.csv")
          .with(CASE.subList(0, 2), row -> row.run.plan())
          .texts(
              "yardstick",
              "`optimal`, `bound` or `best-fixed`: what scores are compared with (the setting"
                  + " `yardsticks`)",
              row -> row.yardstick.policy())
          .longs("seed", "", SEED, row -> row.run.run.result().seed())
          .plain(
              "score",
              "that of `score`",
              "what it came to",
              row -> row.yardstick.score(row.run.run))
          .texts(
              "is",
              "`reached`: a configuration of each step has it; `at most`: none has more, and"
                  + " perhaps none as much",
              row -> row.yardstick.isBound() ? "at most" : "reached");

  /** A row per run and metric, the optima's included. */
  public static final Table<RunMetric> METRICS =
      Table.<RunMetric>of("metrics.csv")
          .with(RUN, RunMetric::run)
          .texts("metric", "its name, see below", row -> row.metric.label())
          .doubles("value", "", "its value", row -> row.run.value(row.metric));

  /** A row per case and metric. */
  public static final Table<CaseMetric> SUMMARY =
      Table.<CaseMetric>of("summary.csv")
          .with(CASE, row -> row.of.plan())
          .texts("metric", "its name", row -> row.metric.label())
          .ints("runs", "", "how many have a value", row -> row.runs)
          .estimates("mean", "", "", "the mean over the seeds", row -> row.mean)
          .texts(
              "difference_to",
              "the first detection that was asked for; empty in its own rows",
              row -> row.reference.map(one -> one.plan().detection().name()).orElse(""))
          .estimates(
              "difference",
              "difference_",
              "",
              "the mean difference to it, paired by seed",
              row -> row.difference);

  /** A row per case and step. */
  public static final Table<CaseStep> STEPS =
      Table.<CaseStep>of("steps.csv.gz")
          .with(CASE, row -> row.of.plan())
          .ints("step", "steps", "from 0", CaseStep::step)
          .doubles(
              "k_min",
              "cameras",
              "the least number of cameras that cover a target (Eq 7.1), the mean over the seeds",
              row -> row.of.meanKMin()[row.step])
          .doubles(
              "score",
              "that of the [objective](objectives.md)",
              "what the objective makes of the step, the mean over the seeds; k_min by default",
              row -> row.of.meanScore()[row.step]);

  /** A part of the run of a case, of {@link FinishedRun#levels equal parts}. */
  record CasePart(CaseResult of, int part) {
    int step() {
      return FinishedRun.start(part, of.levels()[0].length, of.plan().steps());
    }

    Estimate score() {
      return Estimate.mean(Arrays.stream(of.levels()).mapToDouble(run -> run[part]).toArray());
    }
  }

  /** A row per case and part of its runs: what the intervals of curves are made of. */
  public static final Table<CasePart> LEVELS =
      Table.<CasePart>of("levels.csv")
          .with(CASE, row -> row.of.plan())
          .ints(
              "step",
              "steps",
              "at which the part begins: one of fifty equal parts, or a step where there are fewer",
              CasePart::step)
          .estimates(
              "score",
              "",
              "that of `score`, of a step",
              "the mean score of the part, and of that over the seeds",
              CasePart::score);

  private ComparisonFiles() {}

  /**
   * Adds {@code settings.json} and all tables of cases to a folder's files.
   *
   * @param asked the cases that were asked for
   * @param all those, and the optima that they are compared with
   */
  public static void write(OutputFolder folder, List<CaseResult> asked, List<CaseResult> all)
      throws IOException {
    SettingsFile.write(folder, all.stream().map(CaseResult::plan).toList());
    RESULTS.write(folder, runs(asked));
    YARDSTICKS.write(folder, measures(asked));
    METRICS.write(
        folder,
        runs(all).flatMap(run -> run.of.metrics().stream().map(one -> new RunMetric(run, one))));
    SUMMARY.write(
        folder,
        all.stream()
            .flatMap(one -> one.metrics().stream().map(metric -> CaseMetric.of(one, metric, all))));
    LEVELS.write(
        folder,
        all.stream()
            .flatMap(
                one ->
                    IntStream.range(0, one.levels()[0].length)
                        .mapToObj(part -> new CasePart(one, part))));
    STEPS.write(
        folder,
        all.stream()
            .flatMap(
                one ->
                    IntStream.range(0, one.meanKMin().length)
                        .mapToObj(step -> new CaseStep(one, step))));
  }

  private static Stream<Run> runs(List<CaseResult> cases) {
    return cases.stream()
        .flatMap(one -> one.runs().stream().map(run -> new Run(one.plan(), one, run)));
  }

  /** Of the first policy of each scenario and detection: they are the same of all. */
  private static Stream<Measure> measures(List<CaseResult> cases) {
    return Cases.by(cases, one -> ReferencePolicies.Group.of(one.plan())).values().stream()
        .map(group -> group.subList(0, 1))
        .flatMap(
            first ->
                Stream.of(Yardstick.values())
                    .flatMap(yardstick -> runs(first).map(run -> new Measure(run, yardstick))))
        .filter(row -> !Double.isNaN(row.yardstick.score(row.run.run)));
  }

  /** The case of the same scenario and policy under the first detection, if another. */
  private static Optional<CaseResult> firstDetection(CaseResult one, List<CaseResult> cases) {
    return cases.stream()
        .filter(
            other ->
                other.plan().scenario().equals(one.plan().scenario())
                    && other.plan().policy().equals(one.plan().policy()))
        .findFirst()
        .filter(other -> !other.plan().equals(one.plan()));
  }
}
