package org.hificamsim.cli;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.compare.CaseResult;
import org.hificamsim.runs.compare.PolicyScores;
import org.hificamsim.runs.compare.Sample;
import org.hificamsim.runs.compare.Score;
import org.hificamsim.runs.statistics.Aggregate;

/** The tables that a comparison prints when it is done. */
final class ComparisonTable {
  private ComparisonTable() {}

  static void print(PrintWriter out, List<CaseResult> cases) {
    cases(out, cases);
    List<PolicyScores> policies =
        PolicyScores.of(cases.stream().filter(one -> !one.isOptimum()).toList());
    if (policies.stream().anyMatch(one -> one.cases().size() > 1)) {
      out.println();
      aggregates(out, policies);
    }
  }

  /** One row per case; of the optimum, the last column is what adapting is worth. */
  private static void cases(PrintWriter out, List<CaseResult> cases) {
    boolean fixed = cases.stream().anyMatch(one -> one.runs().get(0).bestFixed().isPresent());
    Columns table = new Columns(3);
    table.add("scenario", "detection", "policy", "performance [95%]", "of the optimum [95%]");
    if (fixed) {
      table.addToRow("over best-fixed [95%]");
    }
    for (CaseResult one : cases) {
      table.add(
          one.plan().scenario().name(),
          one.plan().detection().name(),
          one.plan().policy(),
          text("%.0f", one, Score.PERFORMANCE),
          text("%.3f", one, Score.PROPORTION_OF_OPTIMAL));
      if (fixed) {
        table.addToRow(text("%.3f", one, Score.OVER_BEST_FIXED));
      }
    }
    table.print(out);
  }

  /** One row per detection and policy, over all scenarios. */
  private static void aggregates(PrintWriter out, List<PolicyScores> policies) {
    Columns table = new Columns(2);
    table.add("detection", "policy", "interquartile mean [95%]", "optimality gap [95%]");
    for (PolicyScores one : policies) {
      List<String> row = new ArrayList<>(List.of(one.detection(), one.policy()));
      row.add(text("%.3f", Aggregate.IQM.estimate(one.scores())));
      row.add(text("%.3f", Aggregate.OPTIMALITY_GAP.estimate(one.scores())));
      table.add(row.toArray(new String[0]));
    }
    out.println("all scenarios, of the optimum:");
    table.print(out);
  }

  /** A figure's mean; with the number of runs that have it, if not all do. */
  private static String text(String format, CaseResult one, Score score) {
    Sample sample = one.sample(score);
    int runs = one.runs().size();
    String of =
        sample.size() == 0 || sample.size() == runs ? "" : sample.size() + "/" + runs + ": ";
    return of + text(format, sample.mean());
  }

  private static String text(String format, Estimate estimate) {
    String pattern =
        Double.isNaN(estimate.low()) ? format : format + " [" + format + ", " + format + "]";
    return Double.isNaN(estimate.mean())
        ? "-"
        : String.format(Locale.ROOT, pattern, estimate.mean(), estimate.low(), estimate.high());
  }
}
