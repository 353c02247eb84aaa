package org.hificamsim.presentation.plot;

import java.awt.BasicStroke;
import java.awt.Color;
import java.util.List;
import java.util.Locale;
import org.knowm.xchart.style.AxesChartStyler;

/** Gives all panels the same style: a white ground, a pale grid, and no box. */
final class PanelStyle {
  private static final Color GRID = new Color(0xE3E3E3);
  private static final Color AXIS = new Color(0x777777);
  private static final int MARKER_SIZE = 8;

  private PanelStyle() {}

  static void apply(AxesChartStyler style, String xTitle, String yTitle) {
    style.setLocale(Locale.ROOT);
    style.setChartBackgroundColor(Color.WHITE);
    style.setPlotBackgroundColor(Color.WHITE);
    style.setPlotBorderVisible(false);
    style.setLegendVisible(false);
    style.setChartPadding(6);
    style.setPlotContentSize(1);
    style.setPlotMargin(0);
    style.setMarkerSize(MARKER_SIZE);
    titles(style, xTitle, yTitle);
    grid(style);
  }

  private static void titles(AxesChartStyler style, String xTitle, String yTitle) {
    style.setChartTitleVisible(false); // the figure draws titles, in line with each other
    style.setChartFontColor(Palette.BLACK);
    style.setXAxisTitleVisible(!xTitle.isEmpty());
    style.setYAxisTitleVisible(!yTitle.isEmpty());
    style.setAxisTitleFont(Fonts.TEXT);
    style.setAxisTitlePadding(5);
    style.setAxisTickLabelsFont(Fonts.TICKS);
    style.setAxisTickLabelsColor(Palette.BLACK);
  }

  private static void grid(AxesChartStyler style) {
    style.setPlotGridLinesColor(GRID);
    style.setPlotGridLinesStroke(new BasicStroke(0.8f));
    style.setPlotTicksMarksVisible(false);
    style.setAxisTickMarksColor(AXIS);
    style.setAxisTickMarksStroke(new BasicStroke(1));
    style.setAxisTickMarkLength(4);
    style.setXAxisTickMarkSpacingHint(70);
    style.setYAxisTickMarkSpacingHint(32);
  }

  /**
   * Returns the label of a tick: the name of x = 1, 2, 3, ..., otherwise spaces, because XChart
   * requires different labels. Names are padded to be longer than all spaces, because XChart
   * reserves space for the longest label.
   */
  static String name(List<String> names, double x) {
    int i = (int) Math.round(x) - 1;
    boolean isInteger = Math.abs(x - Math.rint(x)) < 1e-9;
    return isInteger && i >= 0 && i < names.size()
        ? names.get(i) + " ".repeat(2 * names.size() + 4)
        : " ".repeat(1 + (int) Math.abs(2 * x));
  }
}
