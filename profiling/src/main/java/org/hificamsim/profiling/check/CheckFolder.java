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
import org.hificamsim.core.file.FileRecord;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.presentation.plot.Curve;
import org.hificamsim.presentation.plot.Figure;
import org.hificamsim.presentation.plot.FigureFile;
import org.hificamsim.presentation.plot.LegendEntry;
import org.hificamsim.presentation.plot.Palette;
import org.hificamsim.presentation.plot.XyPanel;
import org.hificamsim.profiling.check.Calibration.Size;
import org.hificamsim.profiling.dataset.TableLayout;

/** Writes the results of a check: a row per box, a row per rung and distance, and a picture. */
public final class CheckFolder {
  /** The table of errors, overall and by distance. */
  public static final String REALITY = "reality.csv";

  /** The picture of errors over distance, without its ending. */
  public static final String PICTURE = "reality";

  private static final TableLayout<ErrorSummary> SUMMARIES =
      new TableLayout<ErrorSummary>()
          .with("rung", ErrorSummary::rung)
          .with("quantity", ErrorSummary::quantity)
          .with("distance_from", ErrorSummary::from)
          .with("distance_to", ErrorSummary::to)
          .with("boxes", ErrorSummary::boxes)
          .with("median_error", summary -> rounded(6, summary.median()))
          .with("error_90", summary -> rounded(6, summary.ninety()))
          .with("bias", summary -> rounded(6, summary.bias()));

  private static final Map<SizeModel, Color> COLORS =
      new EnumMap<>(Map.of(SizeModel.FLAT, Palette.BLUE, SizeModel.CALIBRATION, Palette.ORANGE));

  private static final int MAX_POINTS = 3000;
  private static final int WIDTH = 560;
  private static final int HEIGHT = 280;

  private CheckFolder() {}

  private static TableLayout<BoxComparison> boxes(RealityCheck check) {
    TableLayout<BoxComparison> layout =
        new TableLayout<BoxComparison>()
            .with("frame", box -> (long) box.sighting().box().frame())
            .with("target", box -> box.sighting().box().target())
            .with("x", box -> rounded(4, box.sighting().foot().getX()))
            .with("y", box -> rounded(4, box.sighting().foot().getY()))
            .with("distance", box -> rounded(4, box.distance()))
            .with("foot_error", box -> rounded(2, box.footError()));
    sizes(layout, "height", size -> rounded(2, size.height()));
    sizes(layout, "pip", size -> rounded(8, check.pip(size)));
    return layout;
  }

  /** Adds a column of a measured quantity, and one of its prediction by each rung. */
  private static void sizes(
      TableLayout<BoxComparison> layout, String name, Function<Size, Object> quantity) {
    layout.with(name, box -> quantity.apply(box.sighting().size()));
    for (SizeModel rung : SizeModel.values()) {
      layout.with(name + "_" + Spelling.of(rung), box -> quantity.apply(box.predicted().get(rung)));
    }
  }

  private static String rounded(int digits, double value) {
    return Texts.format("%." + digits + "f", value);
  }

  /** Writes files next to those of a check. */
  @FunctionalInterface
  public interface FurtherFiles {
    /** Writes the files, without committing them. */
    void write(OutputFolder folder) throws IOException;
  }

  /** Writes the files of a check and further ones, all or none. */
  public static void write(Path path, RealityCheck check, FurtherFiles further) throws IOException {
    try (OutputFolder folder = new OutputFolder(path)) {
      List<ErrorSummary> summaries = new ArrayList<>(check.overall());
      summaries.addAll(check.byDistance());
      folder.write(REALITY, SUMMARIES.csv(summaries));
      folder.write("boxes.csv", boxes(check).csv(check.comparisons()));
      FigureFile.write(folder, PICTURE, figure(check));
      further.write(folder);
      folder.commit(FileRecord.of(path).names());
    }
  }

  /** Draws errors over distance: a point for each box, and a line for the bias of the bands. */
  private static Figure figure(RealityCheck check) {
    List<LegendEntry> legend = new ArrayList<>();
    COLORS.forEach(
        (rung, color) ->
            legend.add(new LegendEntry(Spelling.of(rung), color, LegendEntry.Mark.DOT)));
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
                Curve.of(shown, BoxComparison::distance, box -> 100 * box.error(rung, quantity)),
                Palette.pale(color, 0.27)));
    COLORS.forEach(
        (rung, color) ->
            panel.straight(
                Curve.of(
                    check.byDistance().stream()
                        .filter(band -> band.rung().equals(Spelling.of(rung)))
                        .filter(band -> band.quantity().equals(Spelling.of(quantity)))
                        .toList(),
                    band -> (band.from() + band.to()) / 2,
                    band -> 100 * band.bias()),
                color.darker()));
    return panel;
  }
}
