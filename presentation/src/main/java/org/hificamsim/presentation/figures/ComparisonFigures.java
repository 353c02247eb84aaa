package org.hificamsim.presentation.figures;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.presentation.plot.Figure;
import org.hificamsim.presentation.plot.FigureFile;
import org.hificamsim.runs.compare.CaseResult;

/**
 * The pictures of a comparison: k_min over time, proportions of the optimum, shares covered,
 * profiles.
 */
public final class ComparisonFigures {
  private ComparisonFigures() {}

  /**
   * Writes all pictures.
   *
   * @param cases every case with the optima
   */
  public static void write(OutputFolder folder, List<CaseResult> cases) throws IOException {
    for (Map.Entry<String, List<CaseResult>> scenario : CaseGroups.byScenario(cases).entrySet()) {
      FigureFile.write(
          folder,
          "k_min-" + scenario.getKey(),
          OverTime.figure("k_min over time, " + scenario.getKey(), scenario.getValue()));
    }
    FigureFile.write(folder, "proportion", ProportionFigure.of(cases));
    FigureFile.write(folder, "coverage", coverage(cases));
    if (cases.stream().anyMatch(one -> !one.isOptimum())) {
      FigureFile.write(folder, "profile", ProfileFigure.of(cases));
    }
  }

  private static Figure coverage(List<CaseResult> cases) {
    return CoverageFigure.of(
        "Targets covered by no, one, and more cameras",
        CaseGroups.byScenario(cases).entrySet().stream()
            .flatMap(
                scenario ->
                    CaseGroups.byDetection(scenario.getValue()).entrySet().stream()
                        .map(
                            detection ->
                                new CoverageFigure.Group(
                                    scenario.getKey() + ", " + detection.getKey(),
                                    detection.getValue())))
            .toList(),
        Math.min(3, CaseGroups.byDetection(cases).size()));
  }
}
