package org.hificamsim.reproduction.sensitivity;

import java.awt.Color;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.presentation.figures.PolicyColors;
import org.hificamsim.presentation.plot.Curve;
import org.hificamsim.presentation.plot.Figure;
import org.hificamsim.presentation.plot.FigureFile;
import org.hificamsim.presentation.plot.Palette;
import org.hificamsim.presentation.plot.XyPanel;
import org.hificamsim.reproduction.Layout;
import org.hificamsim.reproduction.sensitivity.Sweeps.ParameterSweep;
import org.knowm.xchart.XYChart;

/** Draws a picture for each parameter, and one of all parameters. */
final class GapFigures {
  private static final int WIDTH = 400;
  private static final int HEIGHT = 270;

  /** The ends of the y axis over the largest values. */
  private static final double AXIS_MARGIN = 1.1;

  private static final String NOTE =
      "Above 0, CamSim's model underestimates. Bands: 95% intervals over seeds; *: default.";

  private final List<Gap> gaps;
  private final PolicyColors colors;

  GapFigures(List<Gap> gaps) {
    this.gaps = gaps;
    this.colors = new PolicyColors(gaps.stream().map(Gap::policy).toList());
  }

  void write(OutputFolder folder, List<ParameterSweep> sweeps) throws IOException {
    for (ParameterSweep sweep : sweeps) {
      FigureFile.write(folder, "sensitivity-" + sweep.parameter(), byLayout(sweep));
    }
    FigureFile.write(folder, "sensitivity", overview(sweeps));
  }

  private Figure byLayout(ParameterSweep sweep) {
    List<Gap> sweepGaps = gaps.stream().filter(gap -> gap.isOf(sweep)).toList();
    return new Figure(
        "What the " + sweep.meaning() + " does to the conclusion of chapter 8",
        NOTE,
        new PolicyColors(colors, sweep.policies()).legend(),
        Arrays.stream(Layout.values())
            .map(layout -> panel(layout.label(), sweep, layout.label(), sweepGaps))
            .toList(),
        Layout.values().length,
        WIDTH,
        HEIGHT);
  }

  private Figure overview(List<ParameterSweep> sweeps) {
    List<Gap> overallGaps = gaps.stream().filter(gap -> gap.layout().equals(Gap.ALL)).toList();
    return new Figure(
        "What each open parameter does to the conclusion of chapter 8",
        "Mean over the three layouts. " + NOTE,
        colors.legend(),
        sweeps.stream()
            .map(sweep -> panel(sweep.parameter(), sweep, Gap.ALL, overallGaps))
            .toList(),
        3,
        WIDTH,
        HEIGHT);
  }

  /**
   * @param scale the gaps that have to fit on the y axis
   */
  private XYChart panel(String title, ParameterSweep sweep, String layout, List<Gap> scale) {
    List<String> values =
        sweep.variants().stream()
            .map(variant -> label(variant.value()) + (variant.isDefault() ? "*" : ""))
            .toList();
    XyPanel panel =
        new XyPanel(title, sweep.parameter(), "hi-fi - CamSim (proportion)")
            .y(least(scale), most(scale))
            .names(values)
            .dashed(
                new Curve(new double[] {0.5, values.size() + 0.5}, new double[] {0, 0}),
                Palette.GREY);
    for (String policy : sweep.policies()) {
      line(panel, gapsOf(sweep, layout, policy), colors.of(policy));
    }
    return panel;
  }

  /** A shorter text, which fits next to the others. */
  private static String label(String value) {
    return value.replaceFirst("^camsim-", "");
  }

  private List<Gap> gapsOf(ParameterSweep sweep, String layout, String policy) {
    return gaps.stream()
        .filter(
            gap ->
                gap.isOf(sweep)
                    && gap.layout().equals(layout)
                    && gap.policy().equals(policy)
                    && !Double.isNaN(gap.difference().mean()))
        .toList();
  }

  private static void line(XyPanel panel, List<Gap> points, Color color) {
    if (points.isEmpty()) {
      return;
    }
    double[] x = points.stream().mapToDouble(gap -> gap.index() + 1).toArray();
    double[] low = points.stream().mapToDouble(gap -> gap.difference().low()).toArray();
    double[] mean = points.stream().mapToDouble(gap -> gap.difference().mean()).toArray();
    double[] high = points.stream().mapToDouble(gap -> gap.difference().high()).toArray();
    if (Arrays.stream(low).noneMatch(Double::isNaN)) { // a single seed has no interval
      panel.band(new Curve(x, low), new Curve(x, high), color);
    }
    panel.straight(new Curve(x, mean), color).dots(new Curve(x, mean), color);
  }

  private static double most(List<Gap> gaps) {
    return Math.max(0.1, AXIS_MARGIN * bounds(gaps).max().orElse(0));
  }

  private static double least(List<Gap> gaps) {
    return Math.min(-0.05, AXIS_MARGIN * bounds(gaps).min().orElse(0));
  }

  private static DoubleStream bounds(List<Gap> gaps) {
    return gaps.stream()
        .map(Gap::difference)
        .flatMapToDouble(
            difference -> DoubleStream.of(difference.low(), difference.mean(), difference.high()))
        .filter(bound -> !Double.isNaN(bound));
  }
}
