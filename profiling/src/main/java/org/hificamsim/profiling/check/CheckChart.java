package org.hificamsim.profiling.check;

import java.awt.Color;
import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.core.Spelling;
import org.hificamsim.profiling.check.ErrorSummary.Quantity;
import org.hificamsim.profiling.report.Charts;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.style.markers.Marker;
import org.knowm.xchart.style.markers.SeriesMarkers;

/** Errors over distance: a point for each box, and the bias of each band as a line. */
record CheckChart(RealityCheck check, Quantity quantity) {
  private static final int MAX_POINTS = 3000;

  static byte[] png(RealityCheck check) {
    return Charts.png(
        List.of(
            new CheckChart(check, Quantity.HEIGHT).chart("box height"),
            new CheckChart(check, Quantity.PIP).chart("PIP")),
        1);
  }

  private XYChart chart(String title) {
    XYChart chart =
        Charts.large(
            title + ": predicted against measured, " + check.boxes() + " boxes",
            "distance, m",
            "error, % of the measured");
    points(chart, SizeModel.FLAT, Charts.BLUE, SeriesMarkers.CIRCLE);
    points(chart, SizeModel.CALIBRATION, Charts.ORANGE, SeriesMarkers.CROSS);
    line(chart, SizeModel.FLAT, Charts.BLUE);
    line(chart, SizeModel.CALIBRATION, Charts.ORANGE);
    chart.getStyler().setLegendVisible(true);
    return chart;
  }

  private void points(XYChart chart, SizeModel rung, Color color, Marker marker) {
    int every = 1 + check.boxes() / MAX_POINTS;
    List<BoxComparison> shown =
        IntStream.range(0, check.boxes())
            .filter(i -> i % every == 0)
            .mapToObj(check.comparisons()::get)
            .toList();
    Charts.points(
        chart,
        Spelling.of(rung),
        shown.stream().mapToDouble(BoxComparison::distance).toArray(),
        shown.stream().mapToDouble(one -> 100 * one.error(rung, quantity)).toArray(),
        new Color(color.getRed(), color.getGreen(), color.getBlue(), 70),
        marker);
  }

  private void line(XYChart chart, SizeModel rung, Color color) {
    List<ErrorSummary> bands =
        check.byDistance().stream()
            .filter(one -> one.rung().equals(Spelling.of(rung)))
            .filter(one -> one.quantity().equals(Spelling.of(quantity)))
            .toList();
    Charts.line(
        chart,
        Spelling.of(rung) + ", bias",
        bands.stream().mapToDouble(one -> (one.from() + one.to()) / 2).toArray(),
        bands.stream().mapToDouble(one -> 100 * one.bias()).toArray(),
        color.darker());
  }
}
