package org.hificamsim.runs.compare;

import java.io.IOException;
import java.util.List;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.RunResult;
import org.hificamsim.runs.output.CsvTable;
import org.hificamsim.runs.output.OutputFolder;
import org.hificamsim.runs.output.Settings;

/** The tables that a comparison writes; {@code docs/data.md} says what each column holds. */
final class ResultFiles {
  private final OutputFolder folder;

  ResultFiles(OutputFolder folder) {
    this.folder = folder;
  }

  /**
   * Writes all tables.
   *
   * @param asked the plans that were asked for
   * @param all those, and the optima beside them
   */
  void write(List<CaseResult> asked, List<CaseResult> all) throws IOException {
    Settings.write(folder.open("settings.json"), all.stream().map(CaseResult::plan).toList());
    results(asked);
    metrics(all);
    summary(all);
    steps(all);
  }

  /** One row per run, the figures of the contract. */
  private void results(List<CaseResult> cases) throws IOException {
    try (CsvTable table =
        new CsvTable(
            folder.open("results.csv"),
            "scenario",
            "detection",
            "policy",
            "seed",
            "performance",
            "proportion_of_optimal",
            "covered_0",
            "covered_1",
            "covered_k")) {
      for (CaseResult one : cases) {
        for (ScoredRun run : one.runs()) {
          RunResult result = run.result();
          table.row(
              one.plan().scenario().name(),
              one.plan().detection().model().name(),
              one.plan().policy(),
              result.seed(),
              result.performance(),
              run.proportionOfOptimal(),
              result.covered0(),
              result.covered1(),
              result.coveredK());
        }
      }
    }
  }

  /** One row per run and figure. */
  private void metrics(List<CaseResult> cases) throws IOException {
    try (CsvTable table =
        new CsvTable(
            folder.open("metrics.csv"),
            "scenario",
            "detection",
            "policy",
            "seed",
            "metric",
            "value")) {
      for (CaseResult one : cases) {
        for (ScoredRun run : one.runs()) {
          for (Score score : one.scores()) {
            table.row(
                one.plan().scenario().name(),
                one.plan().detection().model().name(),
                one.plan().policy(),
                run.result().seed(),
                score.label(),
                score.of(run));
          }
        }
      }
    }
  }

  /** One row per case and figure: mean, interval, and difference to the first detection model. */
  private void summary(List<CaseResult> cases) throws IOException {
    try (CsvTable table =
        new CsvTable(
            folder.open("summary.csv"),
            "scenario",
            "detection",
            "policy",
            "metric",
            "runs",
            "mean",
            "low",
            "high",
            "difference_to",
            "difference",
            "difference_low",
            "difference_high")) {
      for (CaseResult one : cases) {
        for (Score score : one.scores()) {
          summary(table, one, score, reference(one.plan(), cases));
        }
      }
    }
  }

  private static void summary(CsvTable table, CaseResult one, Score score, CaseResult reference) {
    double[] values = one.figures(score);
    Estimate mean = Bootstrap.mean(values);
    boolean paired = !reference.plan().equals(one.plan());
    Estimate difference =
        paired
            ? Bootstrap.difference(values, reference.figures(score))
            : new Estimate(Double.NaN, Double.NaN, Double.NaN);
    table.row(
        one.plan().scenario().name(),
        one.plan().detection().model().name(),
        one.plan().policy(),
        score.label(),
        values.length,
        mean.mean(),
        mean.low(),
        mean.high(),
        paired ? reference.plan().detection().model().name() : "",
        difference.mean(),
        difference.low(),
        difference.high());
  }

  /** The first case of the same scenario and policy: the same targets under the first detection. */
  private static CaseResult reference(RunPlan plan, List<CaseResult> cases) {
    return cases.stream()
        .filter(
            other ->
                other.plan().scenario().equals(plan.scenario())
                    && other.plan().policy().equals(plan.policy()))
        .findFirst()
        .orElseThrow();
  }

  /** One row per case and step: the mean of k_min over the runs. */
  private void steps(List<CaseResult> cases) throws IOException {
    try (CsvTable table =
        new CsvTable(
            folder.openCompressed("steps.csv.gz"),
            "scenario",
            "detection",
            "policy",
            "step",
            "k_min")) {
      for (CaseResult one : cases) {
        for (int step = 0; step < one.meanKMin().length; step++) {
          table.row(
              one.plan().scenario().name(),
              one.plan().detection().model().name(),
              one.plan().policy(),
              step,
              one.meanKMin()[step]);
        }
      }
    }
  }
}
