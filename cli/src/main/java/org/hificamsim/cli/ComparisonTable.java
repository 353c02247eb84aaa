package org.hificamsim.cli;

import java.io.PrintWriter;
import java.util.List;
import java.util.Locale;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.compare.Bootstrap;
import org.hificamsim.runs.compare.CaseResult;
import org.hificamsim.runs.compare.Score;

/** The table that a comparison prints when it is done. */
final class ComparisonTable {
  private static final List<Column> COVERAGE =
      List.of(
          new Column("covered by none [95%]", "%.4f", Score.of(Metric.COVERED_0)),
          new Column("covered by one [95%]", "%.4f", Score.of(Metric.COVERED_1)),
          new Column("covered by more [95%]", "%.4f", Score.of(Metric.COVERED_K)),
          new Column("mean k [95%]", "%.4f", Score.of(Metric.MEAN_K)));

  private ComparisonTable() {}

  private record Column(String title, String format, Score score) {
    String text(CaseResult one) {
      return ComparisonTable.text(format, Bootstrap.mean(one.figures(score)));
    }
  }

  static void print(PrintWriter out, List<CaseResult> cases) {
    List<Column> columns =
        List.of(
            new Column("performance [95%]", "%.0f", Score.PERFORMANCE),
            new Column("of the optimum [95%]", "%.3f", Score.PROPORTION_OF_OPTIMAL));
    print(out, cases, columns);
    if (cases.stream().allMatch(ComparisonTable::isZero)) {
      out.println("no step had every target covered, so performance is 0; shares of targets:");
      print(out, cases, COVERAGE);
      reaches(out, cases);
    }
  }

  private static void print(PrintWriter out, List<CaseResult> cases, List<Column> columns) {
    int scenario = width(cases.stream().map(one -> one.plan().scenario().name()).toList(), 8);
    int detection = width(cases.stream().map(one -> one.plan().detection().name()).toList(), 9);
    int policy = width(cases.stream().map(one -> one.plan().policy()).toList(), 6);
    String names = "%-" + scenario + "s  %-" + detection + "s  %-" + policy + "s";
    out.printf(Locale.ROOT, names, "scenario", "detection", "policy");
    columns.forEach(column -> out.printf("  %26s", column.title()));
    out.println();
    for (CaseResult one : cases) {
      RunPlan plan = one.plan();
      out.printf(
          Locale.ROOT, names, plan.scenario().name(), plan.detection().name(), plan.policy());
      columns.forEach(column -> out.printf("  %26s", column.text(one)));
      out.println();
    }
  }

  private static boolean isZero(CaseResult one) {
    return Bootstrap.mean(one.figures(Score.PERFORMANCE)).mean() == 0;
  }

  /** Why nothing is covered: how far each detection sees in each scenario. */
  private static void reaches(PrintWriter out, List<CaseResult> cases) {
    cases.stream()
        .map(one -> one.plan())
        .map(
            plan ->
                plan.scenario().name()
                    + ", "
                    + plan.detection().name()
                    + ": detected up to "
                    + DetectionHints.reach(plan.scenario(), plan.detection()))
        .distinct()
        .forEach(out::println);
  }

  private static String text(String format, Estimate estimate) {
    String pattern = format + " [" + format + ", " + format + "]";
    return Double.isNaN(estimate.mean())
        ? "-"
        : String.format(Locale.ROOT, pattern, estimate.mean(), estimate.low(), estimate.high());
  }

  private static int width(List<String> texts, int least) {
    return texts.stream().mapToInt(String::length).reduce(least, Math::max);
  }
}
