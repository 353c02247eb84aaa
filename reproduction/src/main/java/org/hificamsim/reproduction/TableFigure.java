package org.hificamsim.reproduction;

import java.awt.Color;
import java.util.List;
import org.hificamsim.presentation.plot.Curve;
import org.hificamsim.presentation.plot.Figure;
import org.hificamsim.presentation.plot.LegendEntry;
import org.hificamsim.presentation.plot.Palette;
import org.hificamsim.presentation.plot.XyPanel;
import org.knowm.xchart.XYChart;

/** Table 8.1 as a picture: our proportions as dots, the published ones as diamonds. */
final class TableFigure {
  private static final List<Layout> LAYOUTS = List.of(Layout.values());
  private static final int WIDTH = 400;
  private static final int HEIGHT = 290;
  private static final double APART = 0.16;
  private static final double BESIDE = 0.08;

  private TableFigure() {}

  static Figure of(List<Table81.Cell> cells) {
    return new Figure(
        "Table 8.1: proportion of the greedy approach's performance",
        "Random and scripted scenario of a layout together; bars: 95% intervals over seeds.",
        List.of(
            new LegendEntry("hi-fi, ours", color(true), LegendEntry.Mark.DOT),
            new LegendEntry("hi-fi, published", pale(true), LegendEntry.Mark.DIAMOND),
            new LegendEntry("CamSim, ours", color(false), LegendEntry.Mark.DOT),
            new LegendEntry("CamSim, published", pale(false), LegendEntry.Mark.DIAMOND),
            new LegendEntry("CamSim by Eq 6.2", Palette.GREY, LegendEntry.Mark.DOT)),
        PublishedCell.POLICIES.stream().map(policy -> panel(policy, cells)).toList(),
        PublishedCell.POLICIES.size(),
        WIDTH,
        HEIGHT);
  }

  private static XYChart panel(String policy, List<Table81.Cell> cells) {
    XyPanel panel =
        new XyPanel(policy, "", "proportion of the optimum")
            .y(0, 1)
            .names(LAYOUTS.stream().map(Layout::label).toList());
    for (Table81.Cell cell : cells) {
      PublishedCell published = cell.published();
      if (published.policy().equals(policy) && !Double.isNaN(cell.ours().mean())) {
        add(panel, cell, published);
      }
    }
    return panel;
  }

  private static void add(XyPanel panel, Table81.Cell cell, PublishedCell published) {
    Color color = color(published.hifi());
    double x = LAYOUTS.indexOf(published.layout()) + 1 + (published.hifi() ? APART : -APART);
    panel.interval(x - BESIDE, cell.ours().low(), cell.ours().high(), color);
    panel.dots(point(x - BESIDE, cell.ours().mean()), color);
    panel.diamonds(point(x + BESIDE, published.proportion()), pale(published.hifi()));
    if (!Double.isNaN(cell.of(Reading.EQ_62))) {
      panel.dots(point(x - 2 * BESIDE, cell.of(Reading.EQ_62)), Palette.GREY);
    }
  }

  private static Curve point(double x, double y) {
    return new Curve(new double[] {x}, new double[] {y});
  }

  private static Color pale(boolean hifi) {
    return Palette.pale(color(hifi), 0.55);
  }

  private static Color color(boolean hifi) {
    return hifi ? Palette.VERMILION : Palette.BLUE;
  }
}
