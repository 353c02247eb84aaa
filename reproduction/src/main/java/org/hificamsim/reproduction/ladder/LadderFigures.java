package org.hificamsim.reproduction.ladder;

import java.awt.Color;
import java.util.List;
import java.util.function.Function;
import org.hificamsim.presentation.figures.FigureStyle;
import org.hificamsim.presentation.plot.Curve;
import org.hificamsim.presentation.plot.Figure;
import org.hificamsim.presentation.plot.LegendEntry;
import org.hificamsim.presentation.plot.Palette;
import org.hificamsim.presentation.plot.XyPanel;
import org.hificamsim.reproduction.ladder.LadderResult.RungResult;
import org.hificamsim.runs.Estimate;
import org.knowm.xchart.XYChart;

/** Draws the pictures of a ladder, whose rungs are rows with the top rung uppermost. */
final class LadderFigures {
  private static final Color TAU = Palette.BLUE;
  private static final Color REGRET = Palette.VERMILION;
  private static final Color COST = Palette.GREEN;
  private static final int WIDTH = 400;
  private static final int ROW_HEIGHT = 24;
  private static final int FRAME_HEIGHT = 80;
  private static final int COLUMNS = 3;

  /** The distance of the dots of a panel from the centre of their row, in rows. */
  private static final double DOT_OFFSET = 0.14;

  private static final double AXIS_MARGIN = 0.05;

  /** The end of the axis of costs over the largest cost. */
  private static final double COST_MARGIN = 1.08;

  private static final String INTERVALS = "Bars: 95% intervals over seeds.";
  private final LadderResult result;
  private final List<String> names;

  LadderFigures(LadderResult result) {
    this.result = result;
    this.names =
        result.inScenario(RungResult.ALL).stream()
            .map(row -> FigureStyle.DEFAULT.name(row.rung().name()))
            .toList();
  }

  /** Returns the figure of tau and regret in each scenario. */
  Figure byScenario() {
    return figure(
        "How far each rung can be trusted, judged by " + top(),
        INTERVALS,
        legend(),
        result.scenarios().stream()
            .filter(scenario -> !scenario.equals(RungResult.ALL))
            .map(this::panel)
            .toList());
  }

  /** The means of tau, regret and cost over the scenarios, in three panels. */
  Figure overview() {
    return figure(
        "How much realism the choice of a policy needs, judged by " + top(),
        "Means over the scenarios. " + INTERVALS + " Nanoseconds are of one machine.",
        List.of(),
        List.of(
            single("order of the policies (Kendall's tau)", -1, RungResult::tau, TAU),
            single(loss() + " (share)", 0, RungResult::share, REGRET),
            costs()));
  }

  private List<LegendEntry> legend() {
    return List.of(
        new LegendEntry("order of the policies: Kendall's tau", TAU, LegendEntry.Mark.DOT),
        new LegendEntry(loss() + ", share of the top rung's best", REGRET, LegendEntry.Mark.DOT));
  }

  private String loss() {
    return result.measure() + " lost by the rung's choice";
  }

  private String top() {
    return names.get(names.size() - 1);
  }

  private Figure figure(String title, String note, List<LegendEntry> legend, List<XYChart> panels) {
    return new Figure(
        title,
        note,
        legend,
        panels,
        Math.min(COLUMNS, panels.size()),
        WIDTH,
        FRAME_HEIGHT + ROW_HEIGHT * Math.max(2, names.size()));
  }

  private XYChart panel(String scenario) {
    XyPanel panel = new XyPanel(scenario, "", "").x(-1 - AXIS_MARGIN, 1 + AXIS_MARGIN).rows(names);
    dots(panel, scenario, RungResult::tau, DOT_OFFSET, TAU);
    dots(panel, scenario, RungResult::share, -DOT_OFFSET, REGRET);
    return panel;
  }

  private XYChart single(
      String title, double least, Function<RungResult, Estimate> figure, Color color) {
    XyPanel panel = new XyPanel(title, "", "").x(least - AXIS_MARGIN, 1 + AXIS_MARGIN).rows(names);
    dots(panel, RungResult.ALL, figure, 0, color);
    return panel;
  }

  private void dots(
      XyPanel panel,
      String scenario,
      Function<RungResult, Estimate> figure,
      double offset,
      Color color) {
    List<RungResult> rungs = result.inScenario(scenario);
    for (int i = 0; i < rungs.size(); i++) {
      Estimate estimate = figure.apply(rungs.get(i));
      if (!Double.isNaN(estimate.mean())) {
        panel.dot(estimate, i + 1 + offset, color);
      }
    }
  }

  private XYChart costs() {
    double[] cost = result.nanoseconds().stream().mapToDouble(nanoseconds -> nanoseconds).toArray();
    double most = result.nanoseconds().stream().reduce(0.0, Math::max);
    XyPanel panel = new XyPanel("cost of a step (ns)", "", "").x(0, COST_MARGIN * most).rows(names);
    for (int i = 0; i < cost.length; i++) {
      panel.dots(new Curve(new double[] {cost[i]}, new double[] {i + 1}), COST);
    }
    return panel;
  }
}
