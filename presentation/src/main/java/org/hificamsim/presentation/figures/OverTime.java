package org.hificamsim.presentation.figures;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.hificamsim.presentation.plot.Figure;
import org.hificamsim.runs.compare.CaseResult;
import org.knowm.xchart.XYChart;

/** k_min over time by policy, a panel per detection model. */
public final class OverTime {
  private static final int WIDTH = 470;
  private static final int HEIGHT = 300;

  private OverTime() {}

  /** The figure of one scenario. */
  public static Figure figure(String title, List<CaseResult> cases) {
    PolicyColors colors = colors(cases);
    double most = ceiling(cases);
    Map<String, List<CaseResult>> detections = CaseGroups.byDetection(cases);
    List<XYChart> panels = new ArrayList<>();
    detections.forEach((name, group) -> panels.add(panel(name, group, colors, most)));
    return new Figure(
        title, note(cases), colors.legend(), panels, Math.min(3, panels.size()), WIDTH, HEIGHT);
  }

  /** A panel of cases that differ in their policy. */
  public static KMinPanel panel(
      String title, List<CaseResult> cases, PolicyColors colors, double most) {
    KMinPanel panel = new KMinPanel(title, cases.get(0).plan().steps(), most);
    cases.forEach(one -> panel.band(one, colors.of(one.plan().policy())));
    cases.forEach(one -> panel.raw(one.meanKMin(), colors.of(one.plan().policy())));
    cases.forEach(one -> panel.smooth(one.plan().policy(), one.meanKMin(), colors));
    return panel;
  }

  /** The colours of the cases' policies. */
  public static PolicyColors colors(List<CaseResult> cases) {
    return new PolicyColors(cases.stream().map(one -> one.plan().policy()).toList());
  }

  /** Where a y axis ends that holds all cases. */
  public static double ceiling(List<CaseResult> cases) {
    return KMinFigure.ceiling(cases.stream().map(CaseResult::meanKMin).toList());
  }

  /** What the note of a figure says of such panels. */
  public static String note(List<CaseResult> cases) {
    int runs = cases.get(0).runs().size();
    return KMinPanel.note(cases.get(0).plan().steps())
        + (runs > 1 ? " (" + runs + " seeds); bands: 95% intervals of that mean." : ".");
  }
}
