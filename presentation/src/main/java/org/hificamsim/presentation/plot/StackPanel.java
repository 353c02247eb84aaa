package org.hificamsim.presentation.plot;

import java.awt.Color;
import java.util.List;
import org.knowm.xchart.CategoryChart;
import org.knowm.xchart.CategorySeries;

/** A panel of stacked bars, with a bar for each name. */
public final class StackPanel extends CategoryChart {
  private static final double BAR_SHARE = 0.72;
  private static final int LABEL_ROTATION = 30;

  private final List<String> names;

  /** Creates an empty panel. */
  public StackPanel(String title, String yTitle, List<String> names) {
    super(400, 300); // figures paint it at another size
    this.names = names;
    setTitle(title);
    setYAxisTitle(yTitle);
    PanelStyle.apply(getStyler(), "", yTitle);
    getStyler().setStacked(true);
    getStyler().setAvailableSpaceFill(BAR_SHARE);
    getStyler().setPlotGridVerticalLinesVisible(false);
    getStyler().setXAxisLabelRotation(LABEL_ROTATION);
    getStyler().setYAxisMin(0.0);
    getStyler().setYAxisMax(1.003);
  }

  /** Adds a layer on top of the others, with a value for each name. */
  public StackPanel layer(List<Double> values, Color color) {
    CategorySeries series = addSeries(String.valueOf(getSeriesMap().size()), names, values);
    series.setFillColor(color);
    return this;
  }
}
