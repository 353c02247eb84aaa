package org.hificamsim.presentation.plot;

import java.awt.Color;
import java.util.List;
import org.knowm.xchart.CategoryChart;
import org.knowm.xchart.CategorySeries;

/** A panel of stacked bars, one per name. */
public final class StackPanel extends CategoryChart {
  private static final double FILL = 0.72;
  private static final int ROTATION = 30;

  private final List<String> names;

  /** An empty panel. */
  public StackPanel(String title, String yTitle, List<String> names) {
    super(400, 300); // figures paint it at a size of their own
    this.names = names;
    setTitle(title);
    setYAxisTitle(yTitle);
    PanelStyle.apply(getStyler(), "", yTitle);
    getStyler().setStacked(true);
    getStyler().setAvailableSpaceFill(FILL);
    getStyler().setPlotGridVerticalLinesVisible(false);
    getStyler().setXAxisLabelRotation(ROTATION);
    getStyler().setYAxisMin(0.0);
    getStyler().setYAxisMax(1.003);
  }

  /** Adds a layer on top of the ones before, one value per name. */
  public StackPanel layer(List<Double> values, Color color) {
    CategorySeries series = addSeries(String.valueOf(getSeriesMap().size()), names, values);
    series.setFillColor(color);
    return this;
  }
}
