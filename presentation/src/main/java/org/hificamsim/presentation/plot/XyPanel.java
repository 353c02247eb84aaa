package org.hificamsim.presentation.plot;

import java.awt.BasicStroke;
import java.awt.Color;
import java.util.List;
import org.hificamsim.runs.Estimate;
import org.knowm.xchart.AnnotationText;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.markers.Marker;
import org.knowm.xchart.style.markers.SeriesMarkers;

/** A panel of lines, bands and points, drawn in the order in which they are added. */
public class XyPanel extends XYChart {
  /** A stroke without round ends, since pale pieces would be darker where round ends overlap. */
  private static final BasicStroke THIN =
      new BasicStroke(0.8f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND);

  private static final BasicStroke THICK = stroke(2.4f);
  private static final BasicStroke INTERVAL = stroke(1.6f);
  private static final BasicStroke DASHED =
      new BasicStroke(
          1.8f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 10, new float[] {5, 4}, 0);
  private static final BasicStroke BAR =
      new BasicStroke(15, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER);
  private static final int SMALL_DOT = 4;
  private static final int MARKS_OF_LINE = 6;

  /** The share of an axis that has dots, so that none is cut off at the ends. */
  private static final double CONTENT_SHARE = 0.94;

  private static final double PALE_LINE = 0.38;
  private static final double PALE_BAND = 0.18;

  /** The approximate width inside a panel, by which XChart sets a tick on each name only. */
  private static final int NAMES_WIDTH = 380;

  private static final int ROW_HEIGHT = 26;

  /** The share by which axes extend beyond their ends, where XChart would omit a tick. */
  private static final double AXIS_MARGIN = 0.003;

  /** Creates an empty panel. */
  public XyPanel(String title, String xTitle, String yTitle) {
    super(400, 300); // figures paint it at another size
    setTitle(title);
    setXAxisTitle(xTitle);
    setYAxisTitle(yTitle);
    PanelStyle.apply(getStyler(), xTitle, yTitle);
  }

  /** Prepares the panel for a cloud of small dots. None is cut off, and ticks have few digits. */
  public XyPanel cloud() {
    getStyler().setMarkerSize(SMALL_DOT);
    getStyler().setPlotContentSize(CONTENT_SHARE);
    getStyler().setDecimalPattern("0.####");
    return this;
  }

  /** Hides the titles of the axes. */
  public XyPanel untitled() {
    getStyler().setAxisTitlesVisible(false);
    return this;
  }

  /** Sets the ends of the x axis. */
  public XyPanel x(double min, double max) {
    getStyler().setXAxisMin(min - AXIS_MARGIN * (max - min));
    getStyler().setXAxisMax(max + AXIS_MARGIN * (max - min));
    return this;
  }

  /** Sets the ends of the y axis. */
  public XyPanel y(double min, double max) {
    getStyler().setYAxisMin(min - AXIS_MARGIN * (max - min));
    getStyler().setYAxisMax(max + AXIS_MARGIN * (max - min));
    return this;
  }

  /** Labels x = 1, 2, 3, ... with names instead of numbering the axis. */
  public XyPanel names(List<String> names) {
    getStyler().setPlotGridVerticalLinesVisible(false);
    getStyler().setXAxisMin(0.5);
    getStyler().setXAxisMax(names.size() + 0.5);
    getStyler().setXAxisTickMarkSpacingHint(NAMES_WIDTH / names.size());
    setCustomXAxisTickLabelsFormatter(x -> PanelStyle.name(names, x));
    return this;
  }

  /** Labels y = 1, 2, 3, ..., from the bottom, with names instead of numbering the axis. */
  public XyPanel rows(List<String> names) {
    getStyler().setYAxisMin(0.5);
    getStyler().setYAxisMax(names.size() + 0.5);
    getStyler().setYAxisTickMarkSpacingHint(ROW_HEIGHT);
    setCustomYAxisTickLabelsFormatter(y -> PanelStyle.name(names, y));
    return this;
  }

  /**
   * Labels x = 0, 1, 2, ... and y = 0, 1, 2, ... with names, as the edges of the cells of a heat
   * map.
   */
  public XyPanel edges(List<String> x, List<String> y) {
    getStyler().setPlotGridLinesVisible(false);
    x(0, x.size() - 1);
    y(0, y.size() - 1);
    getStyler().setXAxisTickMarkSpacingHint(NAMES_WIDTH / 2 / x.size());
    getStyler().setYAxisTickMarkSpacingHint(ROW_HEIGHT);
    setCustomXAxisTickLabelsFormatter(value -> PanelStyle.name(x, value + 1));
    setCustomYAxisTickLabelsFormatter(value -> PanelStyle.name(y, value + 1));
    return this;
  }

  /** Adds a dot with its horizontal interval, if it has one. */
  public XyPanel dot(Estimate estimate, double y, Color color) {
    return dot(estimate, y, LineLook.solid(color));
  }

  /** Adds a mark with its horizontal interval, if it has one. */
  public XyPanel dot(Estimate estimate, double y, LineLook look) {
    if (!Double.isNaN(estimate.low())) {
      double[] ends = {estimate.low(), estimate.high()};
      line(new Curve(ends, new double[] {y, y}), look.color(), INTERVAL);
    }
    return marks(
        new Curve(new double[] {estimate.mean()}, new double[] {y}), look.color(), look.mark());
  }

  /** Adds a thin pale line for the raw values under a smooth line. */
  public XyPanel faint(Curve curve, Color color) {
    return straight(curve, Palette.pale(color, PALE_LINE), THIN);
  }

  /** Adds a line with a policy's dashes, and its mark at some of its points. */
  public XyPanel line(Curve curve, LineLook look) {
    line(curve, look.color(), look.stroke());
    return marksAlong(curve, look);
  }

  /** Adds a line with a policy's dashes and marks that is straight from point to point. */
  public XyPanel straight(Curve curve, LineLook look) {
    straight(curve, look.color(), look.stroke());
    return marksAlong(curve, look);
  }

  private XyPanel marksAlong(Curve curve, LineLook look) {
    int points = Math.min(MARKS_OF_LINE, curve.size());
    double[] x = new double[points];
    double[] y = new double[points];
    for (int i = 0; i < points; i++) {
      int index = (2 * i + 1) * curve.size() / (2 * points);
      x[i] = curve.x()[index];
      y[i] = curve.y()[index];
    }
    return look.mark() == SeriesMarkers.NONE
        ? this
        : marks(new Curve(x, y), look.color(), look.mark());
  }

  /** Makes room for marks at the ends of the axes. */
  public XyPanel wholeMarks() {
    getStyler().setPlotContentSize(CONTENT_SHARE);
    return this;
  }

  /** Adds a horizontal bar, such as a part of a row of {@link #rows}. */
  public XyPanel bar(double from, double to, double y, Color color) {
    return straight(new Curve(new double[] {from, to}, new double[] {y, y}), color, BAR);
  }

  /** Adds a thick line. */
  public XyPanel line(Curve curve, Color color) {
    return line(curve, color, THICK);
  }

  /** Adds a thick line that is straight from point to point. */
  public XyPanel straight(Curve curve, Color color) {
    return straight(curve, color, THICK);
  }

  /** Adds a thin line that is straight from point to point. */
  public XyPanel thin(Curve curve, Color color) {
    return straight(curve, color, THIN);
  }

  /** Adds a dashed line for a reference. */
  public XyPanel dashed(Curve curve, Color color) {
    return line(curve, color, DASHED);
  }

  /** Adds a vertical line for an interval, unless its ends are NaN. */
  public XyPanel interval(double x, double low, double high, Color color) {
    return Double.isNaN(low)
        ? this
        : line(new Curve(new double[] {x, x}, new double[] {low, high}), color, INTERVAL);
  }

  /** Adds the pale area between two curves over the same x, for intervals. */
  public XyPanel band(Curve low, Curve high, Color color) {
    int n = low.size();
    double[] x = new double[2 * n];
    double[] y = new double[2 * n];
    for (int i = 0; i < n; i++) {
      x[i] = low.x()[i];
      y[i] = low.y()[i];
      x[2 * n - 1 - i] = high.x()[i];
      y[2 * n - 1 - i] = high.y()[i];
    }
    XYSeries series = add(new Curve(x, y), SeriesMarkers.NONE);
    series.setXYSeriesRenderStyle(XYSeries.XYSeriesRenderStyle.PolygonArea);
    series.setFillColor(Palette.pale(color, PALE_BAND));
    series.setLineColor(Palette.pale(color, 0));
    series.setLineStyle(THIN);
    return this;
  }

  /**
   * Adds a cell of a heat map from whole coordinates to the next ones, with a text in it.
   *
   * @param share from 0, pale, to 1, dark
   */
  public XyPanel cell(int x, int y, Color color, double share, String text) {
    Curve corners = new Curve(new double[] {x, x, x + 1, x + 1}, new double[] {y, y + 1, y + 1, y});
    XYSeries series = add(corners, SeriesMarkers.NONE);
    series.setXYSeriesRenderStyle(XYSeries.XYSeriesRenderStyle.PolygonArea);
    series.setFillColor(Palette.pale(color, 0.05 + 0.55 * share));
    series.setLineColor(Palette.pale(color, 0));
    series.setLineStyle(THIN);
    addAnnotation(new AnnotationText(text, x + 0.5, y + 0.5, false));
    return this;
  }

  /** Adds dots. */
  public XyPanel dots(Curve curve, Color color) {
    return marks(curve, color, SeriesMarkers.CIRCLE);
  }

  /** Adds diamonds for published values. */
  public XyPanel diamonds(Curve curve, Color color) {
    return marks(curve, color, SeriesMarkers.DIAMOND);
  }

  /** Adds a curved line, which XChart draws as one path. */
  private XyPanel line(Curve curve, Color color, BasicStroke stroke) {
    XYSeries series = add(curve, SeriesMarkers.NONE);
    series.setLineColor(color);
    series.setLineStyle(stroke);
    series.setSmooth(curve.size() > 2);
    return this;
  }

  /** Adds straight lines between points, which XChart draws one by one. */
  private XyPanel straight(Curve curve, Color color, BasicStroke stroke) {
    XYSeries series = add(curve, SeriesMarkers.NONE);
    series.setLineColor(color);
    series.setLineStyle(stroke);
    return this;
  }

  private XyPanel marks(Curve curve, Color color, Marker marker) {
    XYSeries series = add(curve, marker);
    series.setXYSeriesRenderStyle(XYSeries.XYSeriesRenderStyle.Scatter);
    series.setMarkerColor(color);
    return this;
  }

  private XYSeries add(Curve curve, Marker marker) {
    XYSeries series = addSeries(String.valueOf(getSeriesMap().size()), curve.x(), curve.y());
    series.setMarker(marker);
    return series;
  }

  private static BasicStroke stroke(float width) {
    return new BasicStroke(width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
  }
}
