package org.hificamsim.reproduction;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.DetectionRule;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.presentation.plot.Curve;
import org.hificamsim.presentation.plot.Figure;
import org.hificamsim.presentation.plot.FigureFile;
import org.hificamsim.presentation.plot.LegendEntry;
import org.hificamsim.presentation.plot.Palette;
import org.hificamsim.presentation.plot.XyPanel;
import org.knowm.xchart.XYChart;

/**
 * Draws the picture of {@code docs/detection.md}: the probability of a detection over distance for
 * each detector and each f, by chance and by the default threshold.
 */
public final class DetectionFigure {
  private static final List<String> DETECTORS = List.of("orb", "sift", "surf");
  private static final List<String> FEATURES =
      List.of(
          "hifi:%s-lin",
          "hifi:%s-sr", "hifi:%s-svr-lin", "hifi:%s-power", "hifi:%s-pinhole", "lab:%s-svr-rbf");
  private static final double SIZE = 0.66;
  private static final double MAX_DISTANCE = 12;
  private static final int POINTS = 241;

  /** The radius of 50 mm: it is inversely proportional to the focal length, and 2.5 m at 85 mm. */
  private static final ZoomLevel ZOOM =
      new ZoomLevel(2.5 * 85 / 50, 2.5, 7.5, Double.NaN, 2 * Math.PI);

  private DetectionFigure() {}

  /**
   * Writes {@code detection.png}.
   *
   * @param args the folder
   */
  public static void main(String[] args) throws IOException {
    try (OutputFolder folder = new OutputFolder(Path.of(args[0]))) {
      try (OutputStream out = folder.stream("detection.png")) {
        FigureFile.png(out, figure(Catalogue.load()));
      }
      folder.commit(List.of());
    }
  }

  static Figure figure(Catalogue catalogue) {
    List<LegendEntry> legend = new ArrayList<>();
    for (int i = 0; i < DETECTORS.size(); i++) {
      String name = DETECTORS.get(i).toUpperCase(Locale.ROOT) + " by chance";
      legend.add(new LegendEntry(name, Palette.line(i), LegendEntry.Mark.LINE));
    }
    legend.add(
        new LegendEntry(
            "any of them by the default threshold", Palette.GREY, LegendEntry.Mark.DASHES));
    return new Figure(
        "How likely a target is detected, by distance",
        "A target of 0.66 m at 50 mm; alpha 0.05",
        legend,
        FEATURES.stream().map(f -> panel(f, catalogue)).toList(),
        3,
        300,
        230);
  }

  private static XYChart panel(String f, Catalogue catalogue) {
    XyPanel panel =
        new XyPanel(f.replace("%s-", ""), "distance (m)", "probability").x(0, MAX_DISTANCE).y(0, 1);
    DetectionModel first = catalogue.detection(f.formatted(DETECTORS.get(0)));
    panel.dashed(curve(Detection.of(first)), Palette.GREY);
    for (int i = 0; i < DETECTORS.size(); i++) {
      DetectionModel model = catalogue.detection(f.formatted(DETECTORS.get(i)));
      Detection byChance = Detection.by(DetectionRule.parse("chance"), model.name(), model);
      panel.line(curve(byChance), Palette.line(i));
    }
    return panel;
  }

  private static Curve curve(Detection detection) {
    double[] distances = new double[POINTS];
    double[] chances = new double[POINTS];
    for (int i = 0; i < POINTS; i++) {
      distances[i] = MAX_DISTANCE * i / (POINTS - 1);
      chances[i] = detection.chance(detection.model().confidence(SIZE, distances[i], 0, ZOOM));
    }
    return new Curve(distances, chances);
  }
}
