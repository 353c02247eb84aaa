package org.hificamsim.presentation.plot;

import java.awt.Color;
import java.util.List;
import org.knowm.xchart.CategoryChart;
import org.knowm.xchart.CategorySeries;

/** A panel of stacked bars, one per name. */
public final class StackPanel {
  private static final double FILL = 0.72;
  private static final int ROTATION = 30;

  private final CategoryChart chart;
  private final List<String> names;

  /** An empty panel. */
  public StackPanel(String title, String yTitle, List<String> names) {
    this.names = names;
    chart = new CategoryChart(400, 300);
    chart.setTitle(title);
    chart.setYAxisTitle(yTitle);
    PanelStyle.apply(chart.getStyler(), "", yTitle);
    chart.getStyler().setStacked(true);
    chart.getStyler().setAvailableSpaceFill(FILL);
    chart.getStyler().setPlotGridVerticalLinesVisible(false);
    chart.getStyler().setXAxisLabelRotation(ROTATION);
    chart.getStyler().setYAxisMin(0.0);
    chart.getStyler().setYAxisMax(1.003);
  }

  /** Adds a layer on top of the ones before, one value per name. */
  public StackPanel layer(List<Double> values, Color color) {
    CategorySeries series =
        chart.addSeries(String.valueOf(chart.getSeriesMap().size()), names, values);
    series.setFillColor(color);
    return this;
  }

  /** The panel for a figure. */
  public CategoryChart chart() {
    return chart;
  }
}
