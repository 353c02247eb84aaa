package org.hificamsim.runs.compare;

import java.io.IOException;
import java.io.Writer;
import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.output.LatexTable;
import org.hificamsim.runs.statistics.Aggregate;

/** Writes {@code summary.tex}: what a comparison prints on the terminal, for a paper. */
public final class LatexFile {
  private static final String NAME = "summary.tex";

  private LatexFile() {}

  /**
   * Adds the file to a folder's.
   *
   * @param asked the cases that were asked for: every policy under every detection in every
   *     scenario
   * @param all those, and the optima beside them
   */
  public static void write(OutputFolder folder, List<CaseResult> asked, List<CaseResult> all)
      throws IOException {
    try (Writer out = folder.open(NAME)) {
      out.write("% \\usepackage{booktabs}\n");
      out.write(cases(all).text());
      out.write("\n" + aggregates(PolicyScores.of(asked)).text());
    }
  }

  private static LatexTable cases(List<CaseResult> cases) {
    boolean fixed = cases.stream().anyMatch(one -> one.runs().get(0).bestFixed().isPresent());
    List<String> header =
        new ArrayList<>(
            List.of("Scenario", "Detection", "Policy", "Performance", "Of the optimum"));
    header.addAll(fixed ? List.of("Over best-fixed") : List.of());
    boolean scored = cases.stream().anyMatch(one -> one.plan().objective().hasOwnFigure());
    header.addAll(scored ? List.of("Score") : List.of());
    LatexTable table =
        new LatexTable(
            "Means over "
                + cases.get(0).runs().size()
                + " seeds with 95% bootstrap intervals. Performance is k_min summed over "
                + cases.get(0).plan().steps()
                + " steps.",
            "tab:hificamsim",
            3,
            header.toArray(new String[0]));
    for (CaseResult one : byScenario(cases)) {
      List<String> row = new ArrayList<>();
      row.add(one.plan().scenario().name());
      row.add(one.plan().detection().name());
      row.add(one.plan().policy());
      row.add(text("%.0f", one.values(Score.PERFORMANCE).mean()));
      row.add(text("%.3f", one.values(Score.PROPORTION_OF_OPTIMAL).mean()));
      row.addAll(
          fixed ? List.of(text("%.3f", one.values(Score.OVER_BEST_FIXED).mean())) : List.of());
      row.addAll(scored ? List.of(text("%.2f", one.values(Score.SCORE).mean())) : List.of());
      table.row(row.toArray(new String[0]));
    }
    return table;
  }

  /** The optima, which come last, beside the other cases of their scenario. */
  private static List<CaseResult> byScenario(List<CaseResult> cases) {
    List<String> scenarios =
        cases.stream().map(one -> one.plan().scenario().name()).distinct().toList();
    return scenarios.stream()
        .flatMap(name -> cases.stream().filter(one -> one.plan().scenario().name().equals(name)))
        .toList();
  }

  private static LatexTable aggregates(List<PolicyScores> policies) {
    LatexTable table =
        new LatexTable(
            "All scenarios together, proportions of the optimum: interquartile mean and optimality"
                + " gap with 95% stratified bootstrap intervals.",
            "tab:hificamsim-aggregate",
            2,
            "Detection",
            "Policy",
            "Interquartile mean",
            "Optimality gap");
    for (PolicyScores one : policies) {
      table.row(
          one.detection(),
          one.policy(),
          text("%.3f", Aggregate.IQM.estimate(one.scores())),
          text("%.3f", Aggregate.OPTIMALITY_GAP.estimate(one.scores())));
    }
    return table;
  }

  /** A value with its interval; a dash where there is none. */
  private static String text(String format, Estimate value) {
    return Double.isNaN(value.mean()) ? "--" : value.text(format);
  }
}
