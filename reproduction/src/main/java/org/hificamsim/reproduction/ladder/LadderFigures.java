package org.hificamsim.reproduction.ladder;

import java.awt.Color;
import java.util.List;
import java.util.function.Function;
import org.hificamsim.presentation.plot.Curve;
import org.hificamsim.presentation.plot.Figure;
import org.hificamsim.presentation.plot.LegendEntry;
import org.hificamsim.presentation.plot.Palette;
import org.hificamsim.presentation.plot.XyPanel;
import org.hificamsim.reproduction.ladder.LadderResult.RungResult;
import org.hificamsim.runs.Estimate;
import org.knowm.xchart.XYChart;

/** The pictures of a ladder: its rungs are rows, the top one highest. */
final class LadderFigures {
  private static final Color TAU = Palette.BLUE;
  private static final Color REGRET = Palette.VERMILION;
  private static final Color COST = Palette.GREEN;
  private static final int WIDTH = 400;
  private static final int ROW = 24;
  private static final int FRAME = 80;
  private static final int COLUMNS = 3;
  private static final double APART = 0.14;
  private static final double EDGE = 0.05;
  private static final double ROOM = 1.08;
  private static final String INTERVALS = "Bars: 95% intervals over seeds.";
  private final LadderResult result;
  private final List<String> names;

  LadderFigures(LadderResult result) {
    this.result = result;
    this.names = result.of(RungResult.ALL).stream().map(one -> one.rung().name()).toList();
  }

  /** Tau and regret in each scenario, and over all. */
  Figure byScenario() {
    return figure(
        "How far each rung can be trusted, judged by " + top(),
        INTERVALS,
        legend(),
        result.scenarios().stream().map(this::panel).toList());
  }

  /** Tau, regret and cost side by side, the means over the scenarios. */
  Figure overview() {
    return figure(
        "How much realism the choice of a policy needs, judged by " + top(),
        "Means over the scenarios. " + INTERVALS + " Nanoseconds are of one machine.",
        List.of(),
        List.of(
            single("order of the policies (Kendall's tau)", -1, RungResult::tau, TAU),
            single(lost() + " (share)", 0, RungResult::share, REGRET),
            costs()));
  }

  private List<LegendEntry> legend() {
    return List.of(
        new LegendEntry("order of the policies: Kendall's tau", TAU, LegendEntry.Mark.DOT),
        new LegendEntry(lost() + ", share of the top rung's best", REGRET, LegendEntry.Mark.DOT));
  }

  private String lost() {
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
        FRAME + ROW * Math.max(2, names.size()));
  }

  private XYChart panel(String scenario) {
    XyPanel panel = new XyPanel(scenario, "", "").x(-1 - EDGE, 1 + EDGE).rows(names);
    dots(panel, scenario, RungResult::tau, APART, TAU);
    dots(panel, scenario, RungResult::share, -APART, REGRET);
    return panel;
  }

  private XYChart single(
      String title, double least, Function<RungResult, Estimate> figure, Color color) {
    XyPanel panel = new XyPanel(title, "", "").x(least - EDGE, 1 + EDGE).rows(names);
    dots(panel, RungResult.ALL, figure, 0, color);
    return panel;
  }

  private void dots(
      XyPanel panel,
      String scenario,
      Function<RungResult, Estimate> figure,
      double above,
      Color color) {
    List<RungResult> rungs = result.of(scenario);
    for (int i = 0; i < rungs.size(); i++) {
      Estimate estimate = figure.apply(rungs.get(i));
      if (!Double.isNaN(estimate.mean())) {
        panel.dot(estimate, i + 1 + above, color);
      }
    }
  }

  private XYChart costs() {
    double[] cost = result.nanoseconds().stream().mapToDouble(one -> one).toArray();
    double most = result.nanoseconds().stream().reduce(0.0, Math::max);
    XyPanel panel = new XyPanel("cost of a step (ns)", "", "").x(0, ROOM * most).rows(names);
    for (int i = 0; i < cost.length; i++) {
      panel.dots(new Curve(new double[] {cost[i]}, new double[] {i + 1}), COST);
    }
    return panel;
  }
}
