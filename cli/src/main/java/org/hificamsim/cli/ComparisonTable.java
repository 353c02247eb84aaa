package org.hificamsim.cli;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.compare.CaseResult;
import org.hificamsim.runs.compare.PolicyScores;
import org.hificamsim.runs.compare.Score;
import org.hificamsim.runs.compare.SeedValues;
import org.hificamsim.runs.statistics.Aggregate;

/** The tables that a comparison prints when it is done. */
final class ComparisonTable {
  private static final Map<String, Score> COVERAGE = new LinkedHashMap<>();

  static {
    COVERAGE.put("covered by none [95%]", Score.of(Metric.COVERED_0));
    COVERAGE.put("covered by one [95%]", Score.of(Metric.COVERED_1));
    COVERAGE.put("covered by more [95%]", Score.of(Metric.COVERED_K));
    COVERAGE.put("mean k [95%]", Score.of(Metric.MEAN_K));
  }

  private ComparisonTable() {}

  static void print(PrintWriter out, List<CaseResult> cases) {
    cases(out, cases);
    if (cases.stream().allMatch(one -> one.values(Score.SCORE).mean().mean() == 0)) {
      nothing(out, cases);
    }
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
    boolean scored = cases.stream().anyMatch(one -> one.plan().objective().hasOwnFigure());
    Columns table = new Columns(3);
    table.add("scenario", "detection", "policy", "performance [95%]");
    if (scored) {
      table.addToRow("score [95%]");
    }
    table.addToRow("of the optimum [95%]");
    if (fixed) {
      table.addToRow("over best-fixed [95%]");
    }
    for (CaseResult one : cases) {
      table.add(
          one.plan().scenario().name(),
          one.plan().detection().name(),
          one.plan().policy(),
          text("%.0f", one, Score.PERFORMANCE));
      if (scored) {
        table.addToRow(text("%.2f", one, Score.SCORE));
      }
      table.addToRow(text("%.3f", one, Score.PROPORTION_OF_OPTIMAL));
      if (fixed) {
        table.addToRow(text("%.3f", one, Score.OVER_BEST_FIXED));
      }
    }
    table.print(out);
  }

  /** What is covered where performance says nothing, and why: how far each detection sees. */
  private static void nothing(PrintWriter out, List<CaseResult> cases) {
    out.println("no step had every target covered, so performance is 0; shares of targets:");
    Columns table = new Columns(3);
    table.add("scenario", "detection", "policy");
    COVERAGE.forEach((title, score) -> table.addToRow(title));
    for (CaseResult one : cases) {
      RunPlan plan = one.plan();
      table.add(plan.scenario().name(), plan.detection().name(), plan.policy());
      COVERAGE.forEach((title, score) -> table.addToRow(text("%.4f", one, score)));
    }
    table.print(out);
    cases.stream().map(one -> reach(one.plan())).distinct().forEach(out::println);
  }

  private static String reach(RunPlan plan) {
    return plan.scenario().name()
        + ", "
        + plan.detection().name()
        + (plan.detection().certain() ? ": detected up to " : ": detected half of the time up to ")
        + DetectionHints.reach(plan.scenario(), plan.detection());
  }

  /** One row per detection and policy, over all scenarios. */
  private static void aggregates(PrintWriter out, List<PolicyScores> policies) {
    Columns table = new Columns(2);
    table.add("detection", "policy", "interquartile mean [95%]", "optimality gap [95%]");
    for (PolicyScores one : policies) {
      List<String> row = new ArrayList<>(List.of(one.detection(), one.policy()));
      row.add(Aggregate.IQM.estimate(one.scores()).text("%.3f"));
      row.add(Aggregate.OPTIMALITY_GAP.estimate(one.scores()).text("%.3f"));
      table.add(row.toArray(new String[0]));
    }
    out.println("all scenarios, of the optimum:");
    table.print(out);
  }

  /** A figure's mean; with the number of runs that have it, if not all do. */
  private static String text(String format, CaseResult one, Score score) {
    SeedValues values = one.values(score);
    int runs = one.runs().size();
    String of =
        values.size() == 0 || values.size() == runs ? "" : values.size() + "/" + runs + ": ";
    return of + values.mean().text(format);
  }
}
