package org.hificamsim.presentation.figures;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.stream.DoubleStream;
import org.hificamsim.presentation.plot.Figure;
import org.hificamsim.presentation.plot.LegendEntry;
import org.hificamsim.presentation.plot.LineLook;
import org.hificamsim.presentation.plot.Palette;
import org.hificamsim.presentation.plot.XyPanel;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.compare.CaseResult;
import org.hificamsim.runs.compare.Cases;
import org.hificamsim.runs.compare.Yardstick;
import org.knowm.xchart.XYChart;

/**
 * A figure of scores as shares of the yardstick, by policy and detection model, with a panel for
 * each scenario.
 */
final class ProportionFigure {
  private static final int WIDTH = 430;
  private static final int ROW_HEIGHT = 26;
  private static final int FRAME_HEIGHT = 90;

  /** The distance between the dots of a row, in rows. */
  private static final double DOT_DISTANCE = 0.18;

  private final Yardstick yardstick;
  private final List<String> policies;
  private final List<String> detections;
  private final double greatest;
  private final PolicyColors colors;

  private ProportionFigure(
      List<CaseResult> cases, List<String> detections, PolicyColors colors, Yardstick yardstick) {
    this.detections = detections;
    this.colors = colors;
    this.yardstick = yardstick;
    greatest =
        cases.stream()
            .map(this::share)
            .flatMapToDouble(share -> DoubleStream.of(share.mean(), share.high()))
            .filter(Double::isFinite)
            .reduce(1, Math::max);
    policies = new ArrayList<>(Cases.byPolicy(cases).keySet());
    policies.removeIf(PolicyColors::isOptimal);
    Collections.reverse(policies);
  }

  private Estimate share(CaseResult result) {
    return result.mean(yardstick.share());
  }

  static Figure of(
      List<CaseResult> cases, List<String> detections, PolicyColors colors, Yardstick yardstick) {
    ProportionFigure figure = new ProportionFigure(cases, detections, colors, yardstick);
    List<XYChart> panels = new ArrayList<>();
    Cases.byScenario(cases).forEach((name, group) -> panels.add(figure.panel(name, group)));
    return new Figure(
        "Proportion of " + yardstick.noun(),
        "Means over seeds with 95% intervals; "
            + yardstick.noun()
            + " is that of the same detection model"
            + (yardstick.isBound() ? ", and perhaps nothing reaches it." : "."),
        figure.legend(),
        panels,
        Math.min(2, panels.size()),
        WIDTH,
        FRAME_HEIGHT + ROW_HEIGHT * Math.max(2, figure.policies.size()));
  }

  /** Returns the marks of detections; empty if there is one, since policies then have the marks. */
  private List<LegendEntry> legend() {
    return detections.size() == 1
        ? List.of()
        : detections.stream()
            .map(
                name ->
                    LegendEntry.of(
                        colors.name(name), Palette.BLACK, LineLook.mark(detections.indexOf(name))))
            .toList();
  }

  private XYChart panel(String scenario, List<CaseResult> cases) {
    XyPanel panel =
        new XyPanel(scenario, "score / that of " + yardstick.noun(), "")
            .x(0, greatest)
            .rows(policies.stream().map(colors::name).toList())
            .wholeMarks();
    Map<String, List<CaseResult>> groups = Cases.byDetection(cases);
    groups.forEach((name, group) -> group.forEach(result -> dot(panel, result)));
    return panel;
  }

  private void dot(XyPanel panel, CaseResult result) {
    int row = policies.indexOf(result.plan().policy());
    Estimate estimate = share(result);
    if (row >= 0 && !Double.isNaN(estimate.mean())) {
      int detection = detections.indexOf(result.plan().detection().name());
      double y = row + 1 + DOT_DISTANCE * ((detections.size() - 1) / 2.0 - detection);
      LineLook look = colors.of(result);
      LineLook marked = new LineLook(look.color(), LineLook.mark(detection), look.stroke());
      panel.dot(estimate, y, detections.size() == 1 ? look : marked);
    }
  }
}
