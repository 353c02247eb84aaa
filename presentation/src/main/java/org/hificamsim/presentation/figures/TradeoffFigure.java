package org.hificamsim.presentation.figures;

import java.awt.Color;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.hificamsim.data.CsvRow;
import org.hificamsim.presentation.plot.Curve;
import org.hificamsim.presentation.plot.Figure;
import org.hificamsim.presentation.plot.LegendEntry;
import org.hificamsim.presentation.plot.Palette;
import org.hificamsim.presentation.plot.XyPanel;
import org.hificamsim.runs.output.Table;

/** Utility against cost of every network of a study, a panel per scenario, with the front. */
public final class TradeoffFigure {
  private static final int WIDTH = 380;
  private static final int HEIGHT = 300;

  /** Kinds as they lie one upon the other. */
  private static final Map<String, Color> KINDS = new LinkedHashMap<>();

  static {
    KINDS.put("heterogeneous", Palette.SKY);
    KINDS.put("bandit", Palette.VERMILION);
    KINDS.put("homogeneous", Palette.BLUE);
  }

  private TradeoffFigure() {}

  /** The figure of a study's folder. */
  public static Figure of(Path folder) {
    Map<String, List<CsvRow>> scenarios =
        Table.of("networks.csv").read(folder).rows().stream()
            .collect(
                Collectors.groupingBy(
                    row -> row.text("scenario"), LinkedHashMap::new, Collectors.toList()));
    List<XyPanel> panels = new ArrayList<>();
    scenarios.forEach((name, rows) -> panels.add(panel(name, rows)));
    List<LegendEntry> legend = new ArrayList<>();
    KINDS.forEach((kind, color) -> legend.add(new LegendEntry(kind, color, LegendEntry.Mark.DOT)));
    legend.add(new LegendEntry("front", Palette.BLACK, LegendEntry.Mark.LINE));
    return new Figure(
        "Utility for messages",
        "Means over seeds, as shares of the largest; the front is that of strategies that never"
            + " change.",
        legend,
        panels,
        Math.min(3, panels.size()),
        WIDTH,
        HEIGHT);
  }

  private static XyPanel panel(String scenario, List<CsvRow> rows) {
    XyPanel panel = new XyPanel(scenario, "cost", "utility")
            .x(least(rows, "cost_share"), 1)
            .y(least(rows, "utility_share"), 1.005);
    KINDS.forEach(
        (kind, color) -> {
          List<CsvRow> own = rows.stream().filter(row -> row.text("kind").equals(kind)).toList();
          if (!own.isEmpty()) {
            panel.dots(curve(own), color);
          }
        });
    List<CsvRow> front =
        rows.stream()
            .filter(row -> !row.text("kind").equals("bandit"))
            .filter(row -> row.numberOrNaN("below_front") == 0)
            .collect(
                Collectors.toMap(
                    row -> row.numberOrNaN("utility_share"),
                    row -> row,
                    (one, other) -> cost(one) <= cost(other) ? one : other))
            .values()
            .stream()
            .sorted(Comparator.comparingDouble(TradeoffFigure::cost))
            .toList();
    return panel.straight(curve(front), Palette.BLACK);
  }

  private static double least(List<CsvRow> rows, String share) {
    double least = rows.stream().mapToDouble(row -> row.numberOrNaN(share)).min().orElse(0);
    return Math.floor(20 * least) / 20;
  }

  private static double cost(CsvRow row) {
    return row.numberOrNaN("cost_share");
  }

  private static Curve curve(List<CsvRow> rows) {
    return new Curve(
        rows.stream().mapToDouble(TradeoffFigure::cost).toArray(),
        rows.stream().mapToDouble(row -> row.numberOrNaN("utility_share")).toArray());
  }
}
