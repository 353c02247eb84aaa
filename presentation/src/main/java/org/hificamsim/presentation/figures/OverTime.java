package org.hificamsim.presentation.figures;

import java.awt.Color;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.hificamsim.presentation.plot.Figure;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.compare.CaseResult;
import org.hificamsim.runs.compare.Cases;
import org.knowm.xchart.XYChart;

/** The score over time by policy, a panel per detection model. */
public final class OverTime {
  private static final int WIDTH = 470;
  private static final int HEIGHT = 300;

  private OverTime() {}

  /** The figure of one scenario. */
  public static Figure figure(String title, List<CaseResult> cases) {
    PolicyColors colors = colors(cases);
    double most = ceiling(cases);
    Map<String, List<CaseResult>> detections = Cases.byDetection(cases);
    List<XYChart> panels = new ArrayList<>();
    detections.forEach((name, group) -> panels.add(panel(name, group, colors::of, most)));
    return new Figure(
        title, note(cases), colors.legend(), panels, Math.min(3, panels.size()), WIDTH, HEIGHT);
  }

  /** A panel of cases, each in its colour. */
  public static KMinPanel panel(
      String title, List<CaseResult> cases, Function<CaseResult, Color> color, double most) {
    RunPlan plan = cases.get(0).plan();
    KMinPanel panel = new KMinPanel(title, plan.objective(), plan.steps(), most);
    cases.forEach(one -> panel.band(one, color.apply(one)));
    cases.forEach(one -> panel.raw(one.meanScore(), color.apply(one)));
    cases.forEach(one -> panel.smooth(one.plan().policy(), one.meanScore(), color.apply(one)));
    return panel;
  }

  /** The colours of the cases' policies. */
  public static PolicyColors colors(List<CaseResult> cases) {
    return new PolicyColors(cases.stream().map(one -> one.plan().policy()).toList());
  }

  /** Where a y axis ends that holds all cases. */
  public static double ceiling(List<CaseResult> cases) {
    return KMinPanel.ceiling(cases.stream().map(CaseResult::meanScore).toList());
  }

  /** What the note of a figure says of such panels. */
  public static String note(List<CaseResult> cases) {
    int runs = cases.get(0).runs().size();
    return KMinPanel.note(cases.get(0).plan().steps())
        + (runs > 1 ? " (" + runs + " seeds); bands: 95% intervals of that mean." : ".");
  }
}
