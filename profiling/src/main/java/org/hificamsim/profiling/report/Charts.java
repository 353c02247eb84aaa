package org.hificamsim.profiling.report;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Locale;
import javax.imageio.ImageIO;
import org.knowm.xchart.BitmapEncoder;
import org.knowm.xchart.CategoryChart;
import org.knowm.xchart.CategoryChartBuilder;
import org.knowm.xchart.Histogram;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.internal.chartpart.Chart;
import org.knowm.xchart.style.AxesChartStyler;
import org.knowm.xchart.style.markers.Marker;
import org.knowm.xchart.style.markers.SeriesMarkers;

/** The few kinds of chart in the report, in one look, and grids of them as PNG. */
public final class Charts {
  public static final Color BLUE = new Color(0x1f, 0x5f, 0xa8);
  public static final Color ORANGE = new Color(0xe6, 0x9f, 0x00);

  static final Color DOTS = new Color(0x30, 0x30, 0x30, 0xa0);

  private static final int WIDTH = 460;
  private static final int HEIGHT = 340;
  private static final int BINS = 30;

  private Charts() {}

  /** An empty chart of points and lines. */
  static XYChart plot(String title, String x, String y) {
    return plot(title, x, y, WIDTH, HEIGHT);
  }

  /** A larger one, with room for a legend. */
  public static XYChart large(String title, String x, String y) {
    return plot(title, x, y, 2 * WIDTH, HEIGHT + HEIGHT / 3);
  }

  private static XYChart plot(String title, String x, String y, int width, int height) {
    XYChart chart =
        new XYChartBuilder()
            .width(width)
            .height(height)
            .title(title)
            .xAxisTitle(x)
            .yAxisTitle(y)
            .build();
    chart.getStyler().setDefaultSeriesRenderStyle(XYSeries.XYSeriesRenderStyle.Scatter);
    chart.getStyler().setMarkerSize(4);
    chart.getStyler().setDecimalPattern("0.######");
    look(chart.getStyler());
    chart.getStyler().setLegendVisible(false);
    return chart;
  }

  /** Adds points. */
  static XYChart points(XYChart chart, String name, double[] x, double[] y, Color colour) {
    return points(chart, name, x, y, colour, SeriesMarkers.CIRCLE);
  }

  /** Adds points of this shape. */
  public static XYChart points(
      XYChart chart, String name, double[] x, double[] y, Color colour, Marker marker) {
    XYSeries series = chart.addSeries(name, x, y);
    series.setMarkerColor(colour);
    series.setMarker(marker);
    return chart;
  }

  /** Adds a line. */
  public static XYChart line(XYChart chart, String name, double[] x, double[] y, Color colour) {
    XYSeries series = chart.addSeries(name, x, y);
    series.setXYSeriesRenderStyle(XYSeries.XYSeriesRenderStyle.Line);
    series.setMarker(SeriesMarkers.NONE);
    series.setLineColor(colour);
    series.setLineWidth(2);
    return chart;
  }

  /** A histogram. */
  static CategoryChart histogram(String variable, double[] values) {
    Histogram histogram = new Histogram(boxed(values), BINS);
    CategoryChart chart =
        new CategoryChartBuilder()
            .width(WIDTH)
            .height(HEIGHT)
            .title(variable)
            .yAxisTitle("photos")
            .build();
    look(chart.getStyler());
    chart.getStyler().setLegendVisible(false);
    chart.getStyler().setAvailableSpaceFill(0.95);
    chart.getStyler().setXAxisMaxLabelCount(6);
    chart.getStyler().setXAxisDecimalPattern("0.###");
    chart
        .addSeries(variable, histogram.getxAxisData(), histogram.getyAxisData())
        .setFillColor(BLUE);
    return chart;
  }

  /** Charts side by side, row after row, as a PNG file's bytes. */
  public static byte[] png(List<? extends Chart<?, ?>> charts, int columns) {
    List<BufferedImage> pictures = charts.stream().map(BitmapEncoder::getBufferedImage).toList();
    int width = pictures.get(0).getWidth();
    int height = pictures.get(0).getHeight();
    int rows = (pictures.size() + columns - 1) / columns;
    BufferedImage grid =
        new BufferedImage(columns * width, rows * height, BufferedImage.TYPE_INT_RGB);
    Graphics2D graphics = grid.createGraphics();
    graphics.setColor(Color.WHITE);
    graphics.fillRect(0, 0, grid.getWidth(), grid.getHeight());
    for (int i = 0; i < pictures.size(); i++) {
      graphics.drawImage(pictures.get(i), i % columns * width, i / columns * height, null);
    }
    graphics.dispose();
    try (ByteArrayOutputStream bytes = new ByteArrayOutputStream()) {
      ImageIO.write(grid, "png", bytes);
      return bytes.toByteArray();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static void look(AxesChartStyler styler) {
    styler.setLocale(Locale.ROOT);
    styler.setChartBackgroundColor(Color.WHITE);
    styler.setChartTitleFont(new Font(Font.SANS_SERIF, Font.BOLD, 14));
    styler.setPlotContentSize(0.92);
    styler.setChartTitleBoxVisible(false);
  }

  private static List<Double> boxed(double[] values) {
    return java.util.Arrays.stream(values).boxed().toList();
  }
}
