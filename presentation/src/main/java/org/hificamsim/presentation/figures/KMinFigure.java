package org.hificamsim.presentation.figures;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.hificamsim.presentation.plot.Curve;
import org.hificamsim.presentation.plot.Figure;
import org.hificamsim.presentation.plot.Lowess;

/** One panel of k_min over time, a line per label. */
public final class KMinFigure {
  private static final int WIDTH = 620;
  private static final int HEIGHT = 330;

  private KMinFigure() {}

  /** The mean k_min of some runs, by step. */
  public record Line(String label, double[] means) {}

  /** The figure; a line named for a policy has that policy's colour. */
  public static Figure of(String title, String note, List<Line> lines) {
    PolicyColors colors = new PolicyColors(lines.stream().map(Line::label).toList());
    int steps = lines.stream().mapToInt(line -> line.means().length).max().orElseThrow();
    KMinPanel panel = new KMinPanel("", steps, ceiling(lines.stream().map(Line::means).toList()));
    lines.forEach(line -> panel.raw(line.means(), colors.of(line.label())));
    lines.forEach(line -> panel.smooth(line.label(), line.means(), colors));
    return new Figure(title, note, colors.legend(), List.of(panel), 1, WIDTH, HEIGHT);
  }

  /** Where a y axis ends that holds all that is drawn of these, and a tenth more. */
  static double ceiling(List<double[]> means) {
    double most =
        means.stream()
            .map(Curve::of)
            .flatMap(curve -> Stream.of(KMinPanel.drawn(curve), Lowess.smooth(curve)))
            .flatMapToDouble(curve -> Arrays.stream(curve.y()))
            .max()
            .orElse(1);
    return Math.max(0.2, Math.ceil(most * 1.1 * 5) / 5);
  }
}
