package org.hificamsim.presentation.figures;

import java.awt.Color;
import java.util.List;
import org.apache.commons.math3.stat.StatUtils;
import org.hificamsim.presentation.plot.Figure;
import org.hificamsim.presentation.plot.LegendEntry;
import org.hificamsim.presentation.plot.Palette;
import org.hificamsim.presentation.plot.StackPanel;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.compare.CaseResult;

/** Stacked shares of targets covered by no, one, and more cameras, as in Figure 7.9. */
public final class CoverageFigure {
  private static final int WIDTH = 340;
  private static final int HEIGHT = 270;
  private static final Color[] COLORS = {Palette.UNSEEN, Palette.SEEN_ONCE, Palette.SEEN_OFTEN};
  private static final String[] LABELS = {"no camera", "one camera", "two and more"};
  private static final Metric[] METRICS = {Metric.COVERED_0, Metric.COVERED_1, Metric.COVERED_K};

  private CoverageFigure() {}

  /** The cases of one panel, which has a bar for each. */
  public record Group(String title, List<CaseResult> cases) {}

  /** Returns the figure, in the colours of pages. */
  public static Figure of(String title, List<Group> groups, int columns) {
    return new Figure(
        title,
        "Share of targets over all steps, mean over seeds.",
        List.of(legend(0), legend(1), legend(2)),
        groups.stream().map(group -> panel(group)).toList(),
        columns,
        WIDTH,
        HEIGHT);
  }

  private static LegendEntry legend(int layer) {
    return new LegendEntry(LABELS[layer], COLORS[layer], LegendEntry.Mark.BAR);
  }

  private static StackPanel panel(Group group) {
    StackPanel panel =
        new StackPanel(
            group.title(),
            "share of targets",
            group.cases().stream().map(result -> result.plan().policy()).toList());
    for (int layer = 0; layer < METRICS.length; layer++) {
      panel.layer(shares(group, METRICS[layer]), COLORS[layer]);
    }
    return panel;
  }

  private static List<Double> shares(Group group, Metric metric) {
    return group.cases().stream().map(result -> StatUtils.mean(result.figures(metric))).toList();
  }
}
