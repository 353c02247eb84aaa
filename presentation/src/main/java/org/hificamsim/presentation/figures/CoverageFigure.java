package org.hificamsim.presentation.figures;

import java.awt.Color;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.UnaryOperator;
import org.apache.commons.math3.stat.StatUtils;
import org.hificamsim.presentation.plot.Figure;
import org.hificamsim.presentation.plot.LegendEntry;
import org.hificamsim.presentation.plot.Palette;
import org.hificamsim.presentation.plot.XyPanel;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.compare.CaseResult;

/**
 * A figure of bars that show the shares of targets that no, one, and more cameras cover, as Figure
 * 7.9 of the thesis.
 */
public final class CoverageFigure {
  private static final int WIDTH = 340;
  private static final int ROW_HEIGHT = 24;
  private static final int FRAME_HEIGHT = 80;
  private static final Color[] COLORS = {Palette.UNSEEN, Palette.SEEN_ONCE, Palette.SEEN_OFTEN};
  private static final String[] LABELS = {"no camera", "one camera", "two and more"};
  private static final Metric[] METRICS = {Metric.COVERED_0, Metric.COVERED_1, Metric.COVERED_K};

  private CoverageFigure() {}

  /** The cases of one panel, which has a bar for each case. */
  public record Group(String title, List<CaseResult> cases) {}

  /**
   * Returns the figure, in the colours of pages.
   *
   * @param name converts the name of a policy to the words that people read
   */
  public static Figure of(
      String title, List<Group> groups, int columns, UnaryOperator<String> name) {
    int rows = groups.stream().mapToInt(group -> group.cases().size()).max().orElse(0);
    return new Figure(
        title,
        "Share of targets over all steps, mean over seeds.",
        List.of(legend(0), legend(1), legend(2)),
        groups.stream().map(group -> panel(group, name)).toList(),
        columns,
        WIDTH,
        FRAME_HEIGHT + ROW_HEIGHT * Math.max(2, rows));
  }

  private static LegendEntry legend(int layer) {
    return new LegendEntry(LABELS[layer], COLORS[layer], LegendEntry.Mark.BAR);
  }

  private static XyPanel panel(Group group, UnaryOperator<String> name) {
    List<CaseResult> cases = new ArrayList<>(group.cases());
    Collections.reverse(cases);
    List<String> names = cases.stream().map(result -> name.apply(result.plan().policy())).toList();
    XyPanel panel = new XyPanel(group.title(), "share of targets", "").x(0, 1).rows(names);
    for (int row = 0; row < cases.size(); row++) {
      double from = 0;
      for (int layer = 0; layer < METRICS.length; layer++) {
        double to = from + StatUtils.mean(cases.get(row).figures(METRICS[layer]));
        panel.bar(from, to, row + 1, COLORS[layer]);
        from = to;
      }
    }
    return panel;
  }
}
