package org.hificamsim.runs.compare;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.RunResult;
import org.hificamsim.runs.ScoredRun;
import org.hificamsim.runs.output.CsvTable;
import org.hificamsim.runs.output.SettingsFile;
import org.hificamsim.runs.output.Table;

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
    SettingsFile.write(folder, all.stream().map(CaseResult::plan).toList());
    results(asked);
    metrics(all);
    summary(all);
    steps(all);
  }

  /** One row per run, the figures of the contract. */
  private void results(List<CaseResult> cases) throws IOException {
    try (CsvTable table = Table.RESULTS.create(folder)) {
      for (CaseResult one : cases) {
        for (ScoredRun run : one.runs()) {
          RunResult result = run.result();
          row(
              table,
              one,
              result.seed(),
              number(result.value(Metric.PERFORMANCE)),
              run.proportionOfOptimal(),
              result.value(Metric.COVERED_0),
              result.value(Metric.COVERED_1),
              result.value(Metric.COVERED_K),
              number(run.optimum()),
              one.plan().objective().text(),
              number(result.score()));
        }
      }
    }
  }

  /** Whole numbers without a fraction. */
  private static Number number(double value) {
    return value == Math.rint(value) ? (Number) (long) value : (Number) value;
  }

  /** One row per run and figure. */
  private void metrics(List<CaseResult> cases) throws IOException {
    try (CsvTable table = Table.METRICS.create(folder)) {
      for (CaseResult one : cases) {
        for (ScoredRun run : one.runs()) {
          for (Metric metric : one.metrics()) {
            row(table, one, run.result().seed(), metric.label(), metric.of(run));
          }
        }
      }
    }
  }

  /** One row per case and figure: mean, interval, and difference to the first detection model. */
  private void summary(List<CaseResult> cases) throws IOException {
    try (CsvTable table = Table.SUMMARY.create(folder)) {
      for (CaseResult one : cases) {
        for (Metric metric : one.metrics()) {
          summary(table, one, metric, reference(one.plan(), cases));
        }
      }
    }
  }

  private static void summary(CsvTable table, CaseResult one, Metric metric, CaseResult reference) {
    SeedValues values = one.values(metric);
    Estimate mean = values.mean();
    boolean paired = !reference.plan().equals(one.plan());
    Estimate difference =
        paired
            ? SeedValues.ofDifferences(one.figures(metric), reference.figures(metric)).mean()
            : Estimate.single(Double.NaN);
    row(
        table,
        one,
        metric.label(),
        values.size(),
        mean.mean(),
        mean.low(),
        mean.high(),
        paired ? reference.plan().detection().name() : "",
        difference.mean(),
        difference.low(),
        difference.high());
  }

  /** Writes a row that begins with its case. */
  private static void row(CsvTable table, CaseResult one, Object... values) {
    List<Object> row = new ArrayList<>();
    row.add(one.plan().scenario().name());
    row.add(one.plan().detection().name());
    row.add(one.plan().policy());
    row.addAll(Arrays.asList(values));
    table.row(row.toArray());
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
    try (CsvTable table = Table.STEPS.create(folder)) {
      for (CaseResult one : cases) {
        for (int step = 0; step < one.meanKMin().length; step++) {
          row(table, one, step, one.meanKMin()[step]);
        }
      }
    }
  }
}
