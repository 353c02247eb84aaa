package org.hificamsim.runs.compare;

import static java.util.Comparator.comparingDouble;
import static java.util.stream.Collectors.joining;

import java.io.IOException;
import java.io.Writer;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.ScoreText;
import org.hificamsim.runs.output.TextTable;
import org.hificamsim.runs.statistics.Aggregate;

/**
 * What a comparison says in short: the tables that it prints, and {@code summary.tex} for papers.
 */
public final class SummaryTables {
  private static final String LATEX = "summary.tex";

  /**
   * A column of figures.
   *
   * @param format of a number; null for a score, whose objective has it
   */
  private record Figure(String title, String format, Metric metric) {}

  private static final Figure PERFORMANCE = new Figure("performance", "%.0f", Metric.PERFORMANCE);
  private static final Figure SCORE = new Figure("score", null, Metric.SCORE);
  private static final Figure PROPORTION = share(Yardstick.OPTIMAL);
  private static final Figure OF_BOUND = share(Yardstick.BOUND);

  /** Of the optimum it is what adapting is worth. */
  private static final Figure OVER_FIXED = share(Yardstick.BEST_FIXED);

  private SummaryTables() {}

  private static Figure share(Yardstick of) {
    return new Figure(of.title(), "%.3f", of.share());
  }

  /** One row per case, its score compared with the reference policies. */
  public static TextTable cases(List<CaseResult> cases) {
    return table(cases, shown(cases), true);
  }

  /** What the scores of some cases say, by scenario; nothing where all are k_min. */
  public static List<String> meanings(List<CaseResult> cases) {
    return isOfKMin(cases)
        ? List.of()
        : cases.stream()
            .map(one -> one.plan().scenario())
            .map(one -> one.name() + ", score: " + ScoreText.meaning(one.objective()))
            .distinct()
            .toList();
  }

  /** One row per case: what is covered, for cases whose score says nothing. */
  public static TextTable coverage(List<CaseResult> cases) {
    List<Figure> figures =
        Stream.of(Metric.COVERED_0, Metric.COVERED_1, Metric.COVERED_K, Metric.MEAN_K)
            .map(metric -> new Figure(metric.title(), metric.format(), metric))
            .toList();
    return table(cases, figures, true);
  }

  /** How much of what is possible the best policy of each scenario and detection reaches. */
  public static List<String> atLeast(List<CaseResult> cases) {
    List<CaseResult> known = cases.stream().filter(one -> !Double.isNaN(ofBound(one))).toList();
    return Cases.by(known, one -> ReferencePolicies.Group.of(one.plan())).values().stream()
        .map(group -> atLeast(Collections.max(group, comparingDouble(SummaryTables::ofBound))))
        .toList();
  }

  private static double ofBound(CaseResult one) {
    return Estimate.mean(one.figures(Metric.PROPORTION_OF_BOUND)).mean();
  }

  private static String atLeast(CaseResult one) {
    RunPlan plan = one.plan();
    return "%s, %s: %s reaches at least %s %% of what is possible"
        .formatted(
            plan.scenario().name(),
            plan.detection().name(),
            plan.policy(),
            (int) Math.floor(100 * ofBound(one)));
  }

  /** One row per detection and policy, over all scenarios. */
  public static TextTable aggregates(List<PolicyScores> policies) {
    TextTable table =
        new TextTable(2, List.of("detection", "policy", "interquartile mean", "optimality gap"));
    for (PolicyScores one : policies) {
      Map<Aggregate, Estimate> estimates = Aggregate.estimates(one.scores());
      table.row(
          List.of(
              one.detection(),
              one.policy(),
              estimates.get(Aggregate.IQM).text("%.3f"),
              estimates.get(Aggregate.OPTIMALITY_GAP).text("%.3f")));
    }
    return table;
  }

  /**
   * Adds {@code summary.tex} to a folder's files.
   *
   * @param asked the cases that were asked for: every policy under every detection in every
   *     scenario
   * @param all those, and the optima that they are compared with
   */
  public static void writeLatex(OutputFolder folder, List<CaseResult> asked, List<CaseResult> all)
      throws IOException {
    CaseResult first = all.get(0);
    String ofCases = "Means over %s seeds with 95%% intervals.".formatted(first.runs().size());
    String scores =
        isOfKMin(all)
            ? " Performance is k_min summed over %s steps.".formatted(first.plan().steps())
            : meanings(all).stream().map(text -> " " + text + ".").collect(joining());
    Optional<Yardstick> yardstick = Yardstick.of(asked);
    List<Figure> figures = shown(all);
    try (Writer out = folder.open(LATEX)) {
      out.write("% \\usepackage{booktabs}\n");
      out.write(table(byScenario(all), figures, false).latex(ofCases + scores, "tab:hificamsim"));
      if (yardstick.isPresent()) {
        String ofAggregates =
            "All scenarios together, proportions of "
                + yardstick.get().noun()
                + ": interquartile mean and optimality gap with 95% intervals.";
        TextTable aggregates = aggregates(PolicyScores.of(asked));
        out.write("\n" + aggregates.latex(ofAggregates, "tab:hificamsim-aggregate"));
      }
    }
  }

  private static boolean isOfKMin(List<CaseResult> cases) {
    return cases.stream().noneMatch(one -> one.plan().objective().hasOwnFigure());
  }

  /** The figures that say something of these cases, the score first. */
  private static List<Figure> shown(List<CaseResult> cases) {
    List<Figure> shown =
        new ArrayList<>(
            List.of(isOfKMin(cases) ? PERFORMANCE : SCORE, PROPORTION, OF_BOUND, OVER_FIXED));
    for (Yardstick one : Yardstick.values()) {
      shown.removeIf(figure -> figure.metric == one.share() && !one.isIn(cases));
    }
    return shown;
  }

  private static TextTable table(List<CaseResult> cases, List<Figure> figures, boolean counted) {
    List<String> header = new ArrayList<>(List.of("scenario", "detection", "policy"));
    figures.forEach(figure -> header.add(figure.title));
    TextTable table = new TextTable(3, header);
    for (CaseResult one : cases) {
      List<String> row = new ArrayList<>();
      row.add(one.plan().scenario().name());
      row.add(one.plan().detection().name());
      row.add(one.plan().policy());
      figures.forEach(figure -> row.add(text(one, figure, counted)));
      table.row(row);
    }
    return table;
  }

  /**
   * A figure's mean.
   *
   * @param counted whether the number of runs that have it stands before it, if not all do
   */
  private static String text(CaseResult one, Figure figure, boolean counted) {
    double[] figures = one.figures(figure.metric);
    int known = Estimate.known(figures).length;
    boolean some = known > 0 && known < figures.length;
    String count = counted && some ? known + "/" + figures.length + ": " : "";
    return count
        + (figure.format == null
            ? ScoreText.of(one.plan(), figures)
            : figure.metric.shown(figures).text(figure.format));
  }

  /** The cases of each scenario together: the optima come last otherwise. */
  private static List<CaseResult> byScenario(List<CaseResult> cases) {
    return Cases.byScenario(cases).values().stream().flatMap(List::stream).toList();
  }
}
