package org.hificamsim.cli;

import java.io.PrintWriter;
import java.util.List;
import java.util.Locale;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.compare.Bootstrap;
import org.hificamsim.runs.compare.CaseResult;
import org.hificamsim.runs.compare.Score;

/** The table that a comparison prints when it is done. */
final class ComparisonTable {
  private ComparisonTable() {}

  static void print(PrintWriter out, List<CaseResult> cases) {
    int scenario = width(cases.stream().map(one -> one.plan().scenario().name()).toList(), 8);
    int detection = width(cases.stream().map(one -> one.plan().detection().name()).toList(), 9);
    int policy = width(cases.stream().map(one -> one.plan().policy()).toList(), 6);
    String format = "%-" + scenario + "s  %-" + detection + "s  %-" + policy + "s  %26s  %26s%n";
    out.printf(
        Locale.ROOT,
        format,
        "scenario",
        "detection",
        "policy",
        "performance [95%]",
        "of the optimum [95%]");
    for (CaseResult one : cases) {
      out.printf(
          Locale.ROOT,
          format,
          one.plan().scenario().name(),
          one.plan().detection().name(),
          one.plan().policy(),
          text("%.0f", Bootstrap.mean(one.figures(Score.PERFORMANCE))),
          text("%.3f", Bootstrap.mean(one.figures(Score.PROPORTION_OF_OPTIMAL))));
    }
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
