package org.hificamsim.presentation.figures;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import org.hificamsim.presentation.plot.Curve;
import org.hificamsim.presentation.plot.Figure;
import org.hificamsim.presentation.plot.XyPanel;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.compare.CaseResult;
import org.hificamsim.runs.compare.Cases;
import org.hificamsim.runs.compare.PolicyScores;
import org.hificamsim.runs.compare.Yardstick;
import org.hificamsim.runs.statistics.Aggregate;
import org.knowm.xchart.XYChart;

/** A figure of performance profiles: the share of runs that reach each share of the yardstick. */
final class ProfileFigure {
  private static final int WIDTH = 430;
  private static final int HEIGHT = 290;

  private ProfileFigure() {}

  /** Returns the figure of all scenarios together, with a panel for each detection. */
  static Figure of(
      List<CaseResult> cases, List<String> detections, PolicyColors colors, Yardstick yardstick) {
    List<CaseResult> shown = cases.stream().filter(result -> !result.isOptimum()).toList();
    List<XYChart> panels = new ArrayList<>();
    Map<String, List<CaseResult>> groups = Cases.byDetection(shown);
    for (String name : detections) {
      panels.add(panel(colors.name(name), groups.get(name), colors, yardstick));
    }
    return new Figure(
        "Performance profile",
        "Share of all runs whose proportion of "
            + yardstick.noun()
            + " is tau or more; bands: 95% intervals, point by point"
            + PolicyColors.wordsOfBands(Cases.byPolicy(shown).size())
            + ".",
        new PolicyColors(colors, List.copyOf(Cases.byPolicy(shown).keySet())).legend(),
        panels,
        Math.min(2, panels.size()),
        WIDTH,
        HEIGHT);
  }

  private static XyPanel panel(
      String title, List<CaseResult> cases, PolicyColors colors, Yardstick yardstick) {
    XyPanel panel =
        new XyPanel(title, "tau (of " + yardstick.noun() + ")", "share of runs")
            .x(0, 1)
            .y(0, 1)
            .wholeMarks();
    List<PolicyScores> policies =
        PolicyScores.of(cases).stream().filter(policy -> policy.scores().runs() > 0).toList();
    List<Estimate[]> profiles =
        policies.stream().map(policy -> Aggregate.profile(policy.scores())).toList();
    for (int i = 0; i < PolicyColors.banded(policies).size(); i++) {
      band(panel, profiles.get(i), colors, policies.get(i).policy());
    }
    for (int i = 0; i < profiles.size(); i++) {
      panel.straight(curve(profiles.get(i), Estimate::mean), colors.look(policies.get(i).policy()));
    }
    return panel;
  }

  private static void band(XyPanel panel, Estimate[] profile, PolicyColors colors, String policy) {
    if (!Double.isNaN(profile[0].low())) {
      panel.band(curve(profile, Estimate::low), curve(profile, Estimate::high), colors.of(policy));
    }
  }

  private static Curve curve(Estimate[] profile, ToDoubleFunction<Estimate> side) {
    return new Curve(Aggregate.TAUS, Arrays.stream(profile).mapToDouble(side).toArray());
  }
}
