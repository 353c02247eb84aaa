package org.hificamsim.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.Proof;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.RunResult;

/** The short table that a run prints when it is done. */
final class SummaryTable {
  private final PrintWriter out;
  private final List<RunResult> results;

  private SummaryTable(PrintWriter out, List<RunResult> results) {
    this.out = out;
    this.results = results;
  }

  static void print(
      PrintWriter out, RunPlan plan, List<RunResult> results, double[] kMin, Path folder) {
    SummaryTable table = new SummaryTable(out, results);
    table.line("scenario", plan.scenario().name());
    table.line(
        "detection",
        plan.detection().name()
            + (plan.detection().certain() ? ", threshold " : ", half of the time at ")
            + plan.detection().threshold());
    table.line("policy", plan.policy());
    table.line(
        "steps",
        plan.steps()
            + (plan.repeats() == 1
                ? ", seed " + plan.seed()
                : " x "
                    + plan.repeats()
                    + " repeats, seeds "
                    + plan.seed()
                    + " to "
                    + plan.seed(plan.repeats() - 1)));
    table.figures(plan);
    table.unproven(plan);
    table.uncovered(plan);
    table.line("k_min over time", Sparkline.of(kMin));
    table.line("files", folder.toString());
    out.flush();
  }

  /** Says so where the policy's claim to be the best is not proven for every step. */
  private void unproven(RunPlan plan) {
    Proof proof = RunResult.proofOf(results);
    if (proof.unprovenSteps() > 0) {
      line("not proven", proof.missing((long) plan.steps() * plan.repeats(), plan.objective()));
    }
    double gap = results.stream().mapToDouble(RunResult::expectedGap).max().orElse(0);
    if (gap > 0) {
      line("not proven", format("the least expected k of a step might be up to %.3g higher", gap));
    }
  }

  /** Says how far targets are detected where they were never all covered. */
  private void uncovered(RunPlan plan) {
    if (Estimate.of(results, Metric.PERFORMANCE).mean() == 0) {
      line(
          plan.detection().certain() ? "detected up to" : "half of the time",
          DetectionHints.reach(plan.scenario(), plan.detection()));
    }
  }

  private void figures(RunPlan plan) {
    for (Metric metric : Metric.values()) {
      if (metric.isPrinted()) {
        figure(metric.title(), metric, metric.format(), metric.note());
      }
      if (metric == Metric.PERFORMANCE && plan.objective().hasOwnFigure()) {
        figure("score", Metric.SCORE, "%.3f", "sum of " + plan.objective().text());
      }
    }
  }

  private void figure(String label, Metric metric, String format, String unit) {
    Estimate estimate = Estimate.of(results, metric);
    String text = format(format, estimate.mean());
    if (results.size() > 1) {
      text +=
          " [%s, %s]".formatted(format(format, estimate.low()), format(format, estimate.high()));
    }
    line(label, unit.isEmpty() ? text : text + "  (" + unit + ")");
  }

  private static String format(String format, double value) {
    return String.format(Locale.ROOT, format, value);
  }

  private void line(String label, String text) {
    out.printf(Locale.ROOT, "%-16s %s%n", label, text);
  }
}
