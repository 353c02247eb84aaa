package org.hificamsim.profiling.check;

import java.awt.Color;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.IntStream;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.Texts;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.presentation.plot.Curve;
import org.hificamsim.presentation.plot.Figure;
import org.hificamsim.presentation.plot.FigureFile;
import org.hificamsim.presentation.plot.LegendEntry;
import org.hificamsim.presentation.plot.Palette;
import org.hificamsim.presentation.plot.XyPanel;
import org.hificamsim.profiling.check.Calibration.Size;
import org.hificamsim.profiling.dataset.TableLayout;

/** What a check leaves: a row per box, a row per rung and distance, and a picture. */
public final class CheckFolder {
  /** The errors, over all and by distance. */
  public static final String REALITY = "reality.csv";

  /** The errors over distance, a picture. */
  public static final String PICTURE = "reality";

  private static final TableLayout<ErrorSummary> SUMMARIES =
      new TableLayout<ErrorSummary>()
          .with("rung", ErrorSummary::rung)
          .with("quantity", ErrorSummary::quantity)
          .with("distance_from", ErrorSummary::from)
          .with("distance_to", ErrorSummary::to)
          .with("boxes", ErrorSummary::boxes)
          .with("median_error", one -> rounded(6, one.median()))
          .with("error_90", one -> rounded(6, one.ninety()))
          .with("bias", one -> rounded(6, one.bias()));

  private static final Map<SizeModel, Color> COLORS =
      new EnumMap<>(Map.of(SizeModel.FLAT, Palette.BLUE, SizeModel.CALIBRATION, Palette.ORANGE));

  private static final int MAX_POINTS = 3000;
  private static final int WIDTH = 560;
  private static final int HEIGHT = 280;

  private CheckFolder() {}

  private static TableLayout<BoxComparison> boxes(RealityCheck check) {
    TableLayout<BoxComparison> layout =
        new TableLayout<BoxComparison>()
            .with("frame", one -> (long) one.sighting().box().frame())
            .with("target", one -> one.sighting().box().target())
            .with("x", one -> rounded(4, one.sighting().foot().getX()))
            .with("y", one -> rounded(4, one.sighting().foot().getY()))
            .with("distance", one -> rounded(4, one.distance()))
            .with("foot_error", one -> rounded(2, one.footError()));
    sizes(layout, "height", size -> rounded(2, size.height()));
    sizes(layout, "pip", size -> rounded(8, check.pip(size)));
    return layout;
  }

  /** Something of a box as it was measured, and as each rung predicts it. */
  private static void sizes(
      TableLayout<BoxComparison> layout, String name, Function<Size, Object> of) {
    layout.with(name, one -> of.apply(one.sighting().size()));
    for (SizeModel rung : SizeModel.values()) {
      layout.with(name + "_" + Spelling.of(rung), one -> of.apply(one.predicted().get(rung)));
    }
  }

  private static String rounded(int digits, double value) {
    return Texts.format("%." + digits + "f", value);
  }

  /** Writes the files, all or none. */
  public static void write(Path path, RealityCheck check) throws IOException {
    try (OutputFolder folder = new OutputFolder(path)) {
      List<ErrorSummary> all = new ArrayList<>(check.overall());
      all.addAll(check.byDistance());
      folder.write(REALITY, SUMMARIES.csv(all));
      folder.write("boxes.csv", boxes(check).csv(check.comparisons()));
      FigureFile.write(folder, PICTURE, figure(check));
      folder.commit(List.of());
    }
  }

  /** Errors over distance: a point for each box, and the bias of each band as a line. */
  private static Figure figure(RealityCheck check) {
    List<LegendEntry> legend = new ArrayList<>();
    COLORS.forEach(
        (rung, c) -> legend.add(new LegendEntry(Spelling.of(rung), c, LegendEntry.Mark.DOT)));
    return new Figure(
        "Predicted against measured, " + check.boxes() + " boxes",
        "A point for each box, and the bias by distance as a line.",
        legend,
        List.of(
            panel("box height", check, BoxQuantity.HEIGHT), panel("PIP", check, BoxQuantity.PIP)),
        1,
        WIDTH,
        HEIGHT);
  }

  private static XyPanel panel(String title, RealityCheck check, BoxQuantity quantity) {
    XyPanel panel = new XyPanel(title, "distance, m", "error, % of the measured").cloud();
    int every = 1 + check.boxes() / MAX_POINTS;
    List<BoxComparison> shown =
        IntStream.range(0, check.boxes())
            .filter(i -> i % every == 0)
            .mapToObj(check.comparisons()::get)
            .toList();
    COLORS.forEach(
        (rung, color) ->
            panel.dots(
                Curve.of(shown, BoxComparison::distance, one -> 100 * one.error(rung, quantity)),
                Palette.pale(color, 0.27)));
    COLORS.forEach(
        (rung, color) ->
            panel.straight(
                Curve.of(
                    check.byDistance().stream()
                        .filter(one -> one.rung().equals(Spelling.of(rung)))
                        .filter(one -> one.quantity().equals(Spelling.of(quantity)))
                        .toList(),
                    one -> (one.from() + one.to()) / 2,
                    one -> 100 * one.bias()),
                color.darker()));
    return panel;
  }
}
