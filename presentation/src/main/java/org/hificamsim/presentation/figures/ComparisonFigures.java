package org.hificamsim.presentation.figures;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.parallel.Parallel;
import org.hificamsim.presentation.plot.Figure;
import org.hificamsim.presentation.plot.FigureFile;
import org.hificamsim.presentation.plot.PrintWidth;
import org.hificamsim.runs.compare.CaseResult;
import org.hificamsim.runs.compare.Cases;
import org.hificamsim.runs.compare.PolicyScores;
import org.hificamsim.runs.compare.Yardstick;

/**
 * Draws the pictures of a comparison: the score over time, proportions of the optimum, coverage,
 * and performance profiles.
 */
public final class ComparisonFigures {
  private ComparisonFigures() {}

  /**
   * Writes all pictures.
   *
   * @param cases all cases, including the optima
   * @param width the width in print; if empty, the pictures have the size for screens
   * @param style the words and colours of policies
   * @param threads the number of threads, 1 or more
   */
  public static void write(
      OutputFolder folder,
      List<CaseResult> cases,
      Optional<PrintWidth> width,
      FigureStyle style,
      int threads)
      throws IOException {
    PolicyColors colors = PolicyColors.of(cases, style);
    List<CaseResult> ordered = PolicyScores.byScore(cases);
    List<String> policies = List.copyOf(Cases.byPolicy(ordered).keySet());
    Map<String, Supplier<Figure>> figures = figures(ordered, new PolicyColors(colors, policies));
    List<FigureFile.Drawn> drawn =
        Parallel.map(
            List.copyOf(figures.values()), threads, figure -> FigureFile.draw(figure.get(), width));
    int next = 0;
    for (String name : figures.keySet()) {
      drawn.get(next++).write(folder, name);
    }
  }

  private static Map<String, Supplier<Figure>> figures(
      List<CaseResult> cases, PolicyColors colors) {
    Map<String, Supplier<Figure>> figures = new LinkedHashMap<>();
    Cases.byScenario(cases)
        .forEach(
            (name, group) ->
                figures.put(
                    scoreName(group) + "-" + name,
                    () -> KMinPanel.figure(title(group) + " over time, " + name, group, colors)));
    Optional<Yardstick> yardstick = Yardstick.of(cases);
    List<CaseResult> measured =
        yardstick.map(measure -> measured(cases, measure)).orElse(List.of());
    List<String> detections = detections(cases, measured);
    yardstick.ifPresent(
        measure ->
            figures.put(
                "proportion", () -> ProportionFigure.of(measured, detections, colors, measure)));
    figures.put("coverage", () -> coverage(cases, colors));
    if (yardstick.isPresent() && cases.stream().anyMatch(result -> !result.isOptimum())) {
      figures.put("profile", () -> ProfileFigure.of(measured, detections, colors, yardstick.get()));
    }
    return figures;
  }

  /** Returns the cases that have a share of the yardstick; all cases if none has one. */
  private static List<CaseResult> measured(List<CaseResult> cases, Yardstick yardstick) {
    List<CaseResult> measured =
        cases.stream()
            .filter(result -> !Double.isNaN(result.mean(yardstick.share()).mean()))
            .toList();
    return measured.isEmpty() ? cases : measured;
  }

  /** Returns the detections of the measured cases in the order of all cases. */
  private static List<String> detections(List<CaseResult> cases, List<CaseResult> measured) {
    return Cases.byDetection(cases).keySet().stream()
        .filter(Cases.byDetection(measured)::containsKey)
        .toList();
  }

  private static String title(List<CaseResult> cases) {
    return scoreName(cases).equals("score") ? "Score" : "k_min";
  }

  private static String scoreName(List<CaseResult> cases) {
    return cases.get(0).plan().objective().hasOwnFigure() ? "score" : "k_min";
  }

  private static Figure coverage(List<CaseResult> cases, PolicyColors colors) {
    return CoverageFigure.of(
        "Targets covered by no, one, and more cameras",
        Cases.byScenario(cases).entrySet().stream()
            .flatMap(
                scenario ->
                    Cases.byDetection(scenario.getValue()).entrySet().stream()
                        .map(
                            detection ->
                                new CoverageFigure.Group(
                                    scenario.getKey() + ", " + colors.name(detection.getKey()),
                                    detection.getValue())))
            .toList(),
        Math.min(3, Cases.byDetection(cases).size()),
        colors::name);
  }
}
