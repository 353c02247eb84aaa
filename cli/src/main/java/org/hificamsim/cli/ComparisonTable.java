package org.hificamsim.cli;

import java.io.PrintWriter;
import java.util.List;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.compare.CaseResult;
import org.hificamsim.runs.compare.PolicyScores;
import org.hificamsim.runs.compare.SummaryTables;

/** The tables that a comparison prints when it is done. */
final class ComparisonTable {
  private ComparisonTable() {}

  static void print(PrintWriter out, List<CaseResult> cases) {
    SummaryTables.cases(cases).print(out);
    if (cases.stream().allMatch(one -> one.values(Metric.SCORE).mean().mean() == 0)) {
      nothing(out, cases);
    }
    List<PolicyScores> policies =
        PolicyScores.of(cases.stream().filter(one -> !one.isOptimum()).toList());
    if (policies.stream().anyMatch(one -> one.cases().size() > 1)) {
      out.println();
      out.println("all scenarios, of the optimum:");
      SummaryTables.aggregates(policies).print(out);
    }
  }

  /** What is covered where performance says nothing, and why: how far each detection sees. */
  private static void nothing(PrintWriter out, List<CaseResult> cases) {
    out.println("no step had every target covered, so performance is 0; shares of targets:");
    SummaryTables.coverage(cases).print(out);
    cases.stream().map(one -> reach(one.plan())).distinct().forEach(out::println);
  }

  private static String reach(RunPlan plan) {
    return plan.scenario().name()
        + ", "
        + plan.detection().name()
        + (plan.detection().certain() ? ": detected up to " : ": detected half of the time up to ")
        + DetectionHints.reach(plan.scenario(), plan.detection());
  }
}
