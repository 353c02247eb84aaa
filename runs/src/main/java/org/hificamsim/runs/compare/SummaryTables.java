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
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.ScoreText;
import org.hificamsim.runs.output.TextTable;
import org.hificamsim.runs.statistics.Aggregate;

/** Makes the tables that a comparison prints, and {@code summary.tex} for papers. */
public final class SummaryTables {
  private static final String LATEX = "summary.tex";

  /**
   * A column of a table.
   *
   * @param format the format of a number; null for a score, which is formatted by its objective
   */
  private record Figure(String title, String format, Metric metric) {}

  private static final Figure MEAN_K_MIN = new Figure("mean k_min", null, Metric.MEAN_SCORE);
  private static final Figure SCORE = new Figure("score", null, Metric.MEAN_SCORE);
  private static final Figure PROPORTION = share(Yardstick.OPTIMAL);
  private static final Figure SHARE_OF_BOUND = share(Yardstick.BOUND);

  private static final Figure SHARE_OF_REACHABLE = share(Yardstick.REACHABLE);

  /**
   * The share of the best fixed configuration; in the row of the optimum, the value of adapting.
   */
  private static final Figure OVER_FIXED = share(Yardstick.BEST_FIXED);

  private SummaryTables() {}

  private static Figure share(Yardstick yardstick) {
    return new Figure(yardstick.title(), "%.3f", yardstick.share());
  }

  /** A table with each case's score and its share of the main yardstick. */
  public static TextTable cases(List<CaseResult> cases) {
    List<Figure> figures = shown(cases);
    return table(cases, figures.subList(0, Math.min(2, figures.size())), true);
  }

  /** A table with each case's score and its shares of all yardsticks. */
  public static TextTable casesInFull(List<CaseResult> cases) {
    return table(cases, shown(cases), true);
  }

  /** The meaning of the scores in each scenario; empty if all are k_min. */
  public static List<String> meanings(List<CaseResult> cases) {
    return areScoredByKMin(cases)
        ? List.of()
        : cases.stream()
            .map(result -> result.plan().scenario())
            .map(site -> site.name() + ", score: " + ScoreText.meaning(site.objective()))
            .distinct()
            .toList();
  }

  /** A table with each case's coverage, for cases whose scores are all 0. */
  public static TextTable coverage(List<CaseResult> cases) {
    List<Figure> figures =
        Stream.of(Metric.COVERED_0, Metric.COVERED_1, Metric.COVERED_K, Metric.MEAN_K)
            .map(metric -> new Figure(metric.title(), metric.format(), metric))
            .toList();
    return table(cases, figures, true);
  }

  /**
   * A line for each scenario and detection: the share of the bound that the best policy reaches,
   * yardsticks aside.
   */
  public static List<String> sharesOfBound(List<CaseResult> cases) {
    List<CaseResult> known =
        cases.stream()
            .filter(result -> !Yardstick.isYardstick(result.plan().policy()))
            .filter(result -> !Double.isNaN(shareOfBound(result)))
            .toList();
    return Cases.group(known, result -> ReferencePolicies.Group.of(result.plan())).values().stream()
        .map(
            group ->
                lineOfBound(Collections.max(group, comparingDouble(SummaryTables::shareOfBound))))
        .toList();
  }

  private static double shareOfBound(CaseResult result) {
    return result.mean(Metric.PROPORTION_OF_BOUND).mean();
  }

  private static String lineOfBound(CaseResult result) {
    RunPlan plan = result.plan();
    return "%s, %s: %s reaches at least %s %% of what is possible"
        .formatted(
            plan.scenario().name(),
            plan.detection().name(),
            plan.policy(),
            (int) Math.floor(100 * shareOfBound(result)));
  }

  /** A table with aggregates over all scenarios for each detection and policy. */
  public static TextTable aggregates(List<PolicyScores> policies) {
    return aggregates(policies, UnaryOperator.identity());
  }

  private static TextTable aggregates(List<PolicyScores> policies, UnaryOperator<String> names) {
    TextTable table =
        new TextTable(2, List.of("detection", "policy", "interquartile mean", "optimality gap"));
    for (PolicyScores policy : policies) {
      Map<Aggregate, Estimate> estimates = Aggregate.estimates(policy.scores());
      table.row(
          List.of(
              names.apply(policy.detection()),
              names.apply(policy.policy()),
              estimates.get(Aggregate.IQM).text("%.3f"),
              estimates.get(Aggregate.OPTIMALITY_GAP).text("%.3f")));
    }
    return table;
  }

  /**
   * Adds {@code summary.tex} to a folder's files.
   *
   * @param requested the cases that were asked for: every policy under every detection in every
   *     scenario
   * @param all those cases and the optima that they are compared with
   * @param names returns the words that people read for a policy or detection
   */
  public static void writeLatex(
      OutputFolder folder,
      List<CaseResult> requested,
      List<CaseResult> all,
      UnaryOperator<String> names)
      throws IOException {
    CaseResult first = all.get(0);
    String seeds = "Means over %s seeds with 95%% intervals.".formatted(first.runs().size());
    String scores =
        areScoredByKMin(all)
            ? " k_min is the mean of %s steps.".formatted(first.plan().steps())
            : meanings(all).stream().map(text -> " " + text + ".").collect(joining());
    Optional<Yardstick> yardstick = Yardstick.of(requested);
    List<Figure> figures = shown(all);
    try (Writer out = folder.open(LATEX)) {
      out.write("% \\usepackage{booktabs}\n");
      out.write(table(all, figures, false, names).latex(seeds + scores, "tab:hificamsim"));
      if (yardstick.isPresent()) {
        String caption =
            "Aggregates over all runs, proportions of "
                + yardstick.get().noun()
                + ": interquartile mean and optimality gap with 95% intervals.";
        TextTable aggregates = aggregates(PolicyScores.of(requested), names);
        out.write("\n" + aggregates.latex(caption, "tab:hificamsim-aggregate"));
      }
    }
  }

  private static boolean areScoredByKMin(List<CaseResult> cases) {
    return cases.stream().noneMatch(result -> result.plan().objective().hasOwnFigure());
  }

  /** The columns that apply to these cases, the score first. */
  private static List<Figure> shown(List<CaseResult> cases) {
    List<Figure> shown =
        new ArrayList<>(
            List.of(
                areScoredByKMin(cases) ? MEAN_K_MIN : SCORE,
                PROPORTION,
                SHARE_OF_BOUND,
                SHARE_OF_REACHABLE,
                OVER_FIXED));
    for (Yardstick yardstick : Yardstick.values()) {
      shown.removeIf(figure -> figure.metric == yardstick.share() && !yardstick.isIn(cases));
    }
    return shown;
  }

  private static TextTable table(List<CaseResult> cases, List<Figure> figures, boolean showsCount) {
    return table(cases, figures, showsCount, UnaryOperator.identity());
  }

  private static TextTable table(
      List<CaseResult> cases,
      List<Figure> figures,
      boolean showsCount,
      UnaryOperator<String> names) {
    List<String> header = new ArrayList<>(List.of("scenario", "detection", "policy"));
    figures.forEach(figure -> header.add(figure.title));
    TextTable table = new TextTable(3, header);
    for (CaseResult result : byScore(cases)) {
      List<String> row = new ArrayList<>();
      row.add(result.plan().scenario().name());
      row.add(names.apply(result.plan().detection().name()));
      row.add(names.apply(result.plan().policy()));
      figures.forEach(figure -> row.add(text(result, figure, showsCount)));
      table.row(row);
    }
    return table;
  }

  /**
   * Formats the mean of a metric for a cell.
   *
   * @param showsCount whether the number of runs with a value comes first if some have none
   */
  private static String text(CaseResult result, Figure figure, boolean showsCount) {
    double[] figures = result.figures(figure.metric);
    int known = Estimate.known(figures).length;
    boolean isPartial = known > 0 && known < figures.length;
    String count = showsCount && isPartial ? known + "/" + figures.length + ": " : "";
    return count
        + (figure.format == null
            ? ScoreText.of(result.plan(), result.mean(figure.metric))
            : result.mean(figure.metric).text(figure.format));
  }

  /** Sorts the cases of each scenario and detection by their scores, the highest first. */
  private static List<CaseResult> byScore(List<CaseResult> cases) {
    return Cases.byScenario(cases).values().stream()
        .flatMap(scenario -> Cases.byDetection(scenario).values().stream())
        .flatMap(
            detection -> detection.stream().sorted(comparingDouble(SummaryTables::negativeScore)))
        .toList();
  }

  private static double negativeScore(CaseResult result) {
    return -result.mean(Metric.MEAN_SCORE).mean();
  }
}
