package org.hificamsim.runs.compare;

import java.io.IOException;
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

/** Writes the tables of the cases of a comparison, as {@code compare} and similar commands do. */
public final class ComparisonFiles {
  /** The columns that identify a case. */
  public static final List<Column<RunPlan>> CASE =
      Table.<RunPlan>of("")
          .texts(
              "scenario",
              "the scenario file's name without its ending",
              plan -> plan.scenario().name())
          .texts("detection", "the detection's name", plan -> plan.detection().name())
          .texts("policy", "the zoom policy with its options", RunPlan::policy)
          .columns();

  /**
   * A run of a plan.
   *
   * @param result the result of the plan; null for a run without a comparison
   */
  public record Run(RunPlan plan, CaseResult result, ScoredRun scored) {
    /** A run without any yardstick. */
    public static Run alone(RunPlan plan, RunResult result) {
      return new Run(plan, null, new ScoredRun(result, Double.NaN, Double.NaN, Double.NaN));
    }

    double value(Metric metric) {
      return scored.value(metric);
    }
  }

  /** A metric of a run. */
  record RunMetric(Run run, Metric metric) {}

  /**
   * A metric of a case.
   *
   * @param runs the number of runs with a value
   * @param reference the case under the first detection; empty if it is this case itself
   * @param difference the mean difference to the reference
   */
  record CaseMetric(
      CaseResult result,
      Metric metric,
      int runs,
      Estimate mean,
      Optional<CaseResult> reference,
      Estimate difference) {
    static CaseMetric of(CaseResult result, Metric metric, List<CaseResult> cases) {
      double[] figures = result.figures(metric);
      Optional<CaseResult> reference = firstDetection(result, cases);
      Estimate difference =
          reference
              .map(other -> Estimate.difference(figures, other.figures(metric)))
              .orElse(Estimate.single(Double.NaN));
      int runs = Estimate.known(figures).length;
      return new CaseMetric(result, metric, runs, result.mean(metric), reference, difference);
    }
  }

  /**
   * The score of a yardstick with the seed of a run.
   *
   * @param isBound whether it is a bound, and not the score of a configuration
   */
  record YardstickScore(Run run, Yardstick yardstick, double score, boolean isBound) {
    static Stream<YardstickScore> of(Run run, Yardstick yardstick) {
      double score = yardstick.score(run.scored);
      YardstickScore main = new YardstickScore(run, yardstick, score, yardstick.isBound());
      double reached = run.scored.reachable().reached();
      return yardstick == Yardstick.REACHABLE
          ? Stream.of(new YardstickScore(run, yardstick, reached, false), main)
          : Stream.of(main);
    }
  }

  /** A step of a case. */
  record CaseStep(CaseResult result, int step) {}

  private static final String SEED = "the run's seed: first seed + repeat";
  private static final List<Column<Run>> RUN =
      Table.<Run>of("")
          .with(CASE, Run::plan)
          .longs("seed", "", SEED, run -> run.scored.result().seed())
          .columns();

  /** A table with a row for each run that was asked for. */
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
              "the score of the optimum, by which the proportion is divided; empty where the"
                  + " optimum is not a yardstick",
              run -> run.scored.optimum())
          .texts(
              "objective",
              "the score of a step ([objectives](objectives.md))",
              run -> run.plan().objective().text())
          .plain(Metric.SCORE, Run::value)
          .doubles(Metric.PROPORTION_OF_REACHABLE, Run::value)
          .doubles(Metric.MEAN_SCORE, Run::value);

  /** A table with a row for each scenario, detection, yardstick and seed. */
  public static final Table<YardstickScore> YARDSTICKS =
      Table.<YardstickScore>of("yardsticks.csv")
          .with(CASE.subList(0, 2), row -> row.run.plan())
          .texts(
              "yardstick",
              "`optimal`, `bound`, `best-fixed` or `reachable`: what scores are compared with (the"
                  + " setting `yardsticks`)",
              row -> row.yardstick.policy())
          .longs("seed", "", SEED, row -> row.run.scored.result().seed())
          .plain("score", "that of `score`", "the score of the yardstick", row -> row.score)
          .texts(
              "is",
              "`reached`: configurations have this score; `at most`: none has more, and perhaps"
                  + " none as much",
              row -> row.isBound ? "at most" : "reached");

  /** A table with a row for each run and metric, including the runs of the optima. */
  public static final Table<RunMetric> METRICS =
      Table.<RunMetric>of("metrics.csv")
          .with(RUN, RunMetric::run)
          .texts("metric", "the metric's name, see below", row -> row.metric.label())
          .doubles("value", "", "the metric's value", row -> row.run.value(row.metric));

  /** A table with a row for each case and metric. */
  public static final Table<CaseMetric> SUMMARY =
      Table.<CaseMetric>of("summary.csv")
          .with(CASE, row -> row.result.plan())
          .texts("metric", "the metric's name", row -> row.metric.label())
          .ints("runs", "", "number with a value", row -> row.runs)
          .estimates("mean", "", "", "the mean over the seeds", row -> row.mean)
          .texts(
              "difference_to",
              "the first detection that was asked for; empty in its own rows",
              row -> row.reference.map(result -> result.plan().detection().name()).orElse(""))
          .estimates(
              "difference",
              "difference_",
              "",
              "the mean difference to `difference_to`, paired by seed",
              row -> row.difference);

  /** A table with a row for each case and step. */
  public static final Table<CaseStep> STEPS =
      Table.<CaseStep>of("steps.csv.gz")
          .with(CASE, row -> row.result.plan())
          .ints("step", "steps", "from 0", CaseStep::step)
          .doubles(
              "k_min",
              "cameras",
              "the least number of cameras that cover a target (Eq 7.1), the mean over the seeds",
              row -> row.result.meanKMin()[row.step])
          .doubles(
              "score",
              "that of the [objective](objectives.md)",
              "the step's score, the mean over the seeds; k_min by default",
              row -> row.result.meanScore()[row.step]);

  /** One of the {@link FinishedRun#partMeans equal parts} of the runs of a case. */
  record CasePart(CaseResult result, int part) {
    int step() {
      return FinishedRun.start(part, result.partMeans()[0].length, result.plan().steps());
    }

    Estimate score() {
      return result.partMean(part);
    }
  }

  /** A table with a row for each case and part of its runs, for the intervals of curves. */
  public static final Table<CasePart> LEVELS =
      Table.<CasePart>of("levels.csv")
          .with(CASE, row -> row.result.plan())
          .ints(
              "step",
              "steps",
              "first step of the part, which is one of fifty equal parts of the run; in runs of"
                  + " fewer steps each step is a part",
              CasePart::step)
          .estimates(
              "score",
              "",
              "that of `score`, of a step",
              "the mean score of the part, the mean over the seeds",
              CasePart::score);

  private ComparisonFiles() {}

  /**
   * Adds {@code settings.json} and all tables of cases to a folder's files.
   *
   * @param requested the cases that were asked for
   * @param all those cases and the optima that they are compared with
   */
  public static void write(OutputFolder folder, List<CaseResult> requested, List<CaseResult> all)
      throws IOException {
    SettingsFile.write(folder, all.stream().map(CaseResult::plan).toList());
    RESULTS.write(folder, runs(requested));
    YARDSTICKS.write(folder, yardstickScores(requested));
    METRICS.write(
        folder,
        runs(all)
            .flatMap(
                run -> run.result.metrics().stream().map(metric -> new RunMetric(run, metric))));
    SUMMARY.write(
        folder,
        all.stream()
            .flatMap(
                result ->
                    result.metrics().stream().map(metric -> CaseMetric.of(result, metric, all))));
    LEVELS.write(
        folder,
        all.stream()
            .flatMap(
                result ->
                    IntStream.range(0, result.partMeans()[0].length)
                        .mapToObj(part -> new CasePart(result, part))));
    STEPS.write(
        folder,
        all.stream()
            .flatMap(
                result ->
                    IntStream.range(0, result.meanKMin().length)
                        .mapToObj(step -> new CaseStep(result, step))));
  }

  private static Stream<Run> runs(List<CaseResult> cases) {
    return cases.stream()
        .flatMap(result -> result.runs().stream().map(run -> new Run(result.plan(), result, run)));
  }

  /** The scores for each scenario, detection, yardstick and seed, which all policies share. */
  private static Stream<YardstickScore> yardstickScores(List<CaseResult> cases) {
    return Cases.group(cases, result -> ReferencePolicies.Group.of(result.plan())).values().stream()
        .map(group -> group.subList(0, 1))
        .flatMap(
            first ->
                Stream.of(Yardstick.values())
                    .flatMap(
                        yardstick -> runs(first).flatMap(run -> YardstickScore.of(run, yardstick))))
        .filter(row -> !Double.isNaN(row.score));
  }

  /**
   * The case of the same scenario and policy under the first detection; empty if it is the same.
   */
  private static Optional<CaseResult> firstDetection(CaseResult result, List<CaseResult> cases) {
    return cases.stream()
        .filter(
            other ->
                other.plan().scenario().equals(result.plan().scenario())
                    && other.plan().policy().equals(result.plan().policy()))
        .findFirst()
        .filter(other -> !other.plan().equals(result.plan()));
  }
}
