package org.hificamsim.presentation.figures;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.util.Arrays;
import java.util.List;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.presentation.plot.Curve;
import org.hificamsim.presentation.plot.LineLook;
import org.junit.jupiter.api.Test;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYSeries;

class KMinPanelTest {
  @Test
  void axisContainsAllDrawnPoints() {
    double[] peak = new double[1000];
    Arrays.fill(peak, 0.5);
    Arrays.fill(peak, 400, 405, 2.9);
    XYChart chart = panel(peak);
    for (XYSeries series : chart.getSeriesMap().values()) {
      double greatest = Arrays.stream(series.getYData()).max().orElseThrow();
      assertTrue(greatest < chart.getStyler().getYAxisMax(), greatest + " is cut off");
    }
    assertEquals(2.9, Arrays.stream(KMinPanel.drawn(Curve.of(peak)).y()).max().orElse(0), 1e-9);
  }

  @Test
  void axisEndsWhereDataDoWithRoomForMarks() {
    assertEquals(1, KMinPanel.ceiling(List.of(new double[] {0, 1, 0.5})));
    assertEquals(0.8, KMinPanel.ceiling(List.of(new double[] {0.7})));
    assertTrue(panel(new double[] {0, 1, 0.5}).getStyler().getPlotContentSize() < 0.95);
  }

  @Test
  void noteTellsSmoothingAndThinning() {
    assertEquals("Mean over the runs", KMinPanel.note(19));
    assertEquals("Thick: LOWESS; pale: mean over the runs", KMinPanel.note(250));
    assertTrue(KMinPanel.note(251).contains("in 250 groups of steps"));
  }

  @Test
  void onlyLinesWithEnoughPointsAreSmooth() {
    for (int steps : new int[] {5, 1000}) {
      double[] means = new double[steps];
      Arrays.setAll(means, i -> i % 2);
      List<Boolean> bent =
          panel(means).getSeriesMap().values().stream()
              .limit(2) // then marks
              .map(XYSeries::isSmooth)
              .toList();
      assertEquals(List.of(false, steps >= 20), bent);
    }
  }

  private static KMinPanel panel(double[] means) {
    double ceiling = KMinPanel.ceiling(List.of(means));
    KMinPanel panel = new KMinPanel("", Objective.kMin(), means.length, ceiling);
    panel.raw(means, Color.BLUE);
    panel.smooth(means, LineLook.solid(Color.BLUE));
    return panel;
  }
}
