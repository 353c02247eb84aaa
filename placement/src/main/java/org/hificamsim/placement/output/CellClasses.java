package org.hificamsim.placement.output;

import java.awt.Color;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.hifi.density.DensityDetections;
import org.hificamsim.placement.site.CameraPlan;
import org.hificamsim.placement.site.Demand;
import org.hificamsim.placement.site.Demand.ZoneDemand;
import org.hificamsim.placement.site.PointSight;
import org.hificamsim.presentation.plot.Palette;
import org.hificamsim.runs.cells.FieldCells;

/**
 * The cells of a plan, sorted into classes by what cameras see of them. A picture of the plan
 * colours them by class.
 *
 * @param values for each cell, the number of its class; NaN if no zone asks for the cell
 * @param colors the colors of the classes
 * @param labels the labels of the classes
 */
record CellClasses(FieldCells cells, double[] values, List<Color> colors, List<String> labels) {
  /**
   * Returns classes that say how many cameras see a cell: none, fewer than one of its zones asks
   * for, or as many as all its zones ask for.
   */
  static CellClasses coverage(CameraPlan plan) {
    FieldCells cells = plan.demand().finestCells();
    double[] classes = new double[cells.count()];
    Arrays.fill(classes, Double.NaN);
    int[] counts = plan.cover().counts();
    forEachPoint(
        plan.demand(),
        (cell, zone, point) -> {
          int pointClass = counts[point] == 0 ? 0 : counts[point] < zone.k() ? 1 : 2;
          double before = classes[cell];
          classes[cell] = Double.isNaN(before) ? pointClass : Math.min(before, pointClass);
        });
    return new CellClasses(
        cells,
        classes,
        List.of(Palette.UNSEEN, Palette.SEEN_ONCE, Palette.SEEN_OFTEN),
        List.of("seen by no camera", "by fewer than asked for", "as asked for"));
  }

  /** Receives the cells in which zones ask for something. */
  private interface CellPoint {
    void accept(int cell, ZoneDemand zone, int point);
  }

  /**
   * Calls the receiver for each zone and each cell of the finest grid in which the zone asks for
   * something.
   */
  private static void forEachPoint(Demand demand, CellPoint receiver) {
    for (ZoneDemand zone : demand.zones()) {
      int[] points = demand.pointsByCell(zone, demand.finestCells());
      for (int cell = 0; cell < points.length; cell++) {
        if (points[cell] >= 0) {
          receiver.accept(cell, zone, points[cell]);
        }
      }
    }
  }

  /**
   * Returns classes that say the highest level of a standard that cameras reach in each cell. The
   * result is empty if zones ask for no level, or for levels of two standards.
   */
  static Optional<CellClasses> levels(CameraPlan plan, Catalogue catalogue) {
    List<String> asked =
        plan.demand().zones().stream().map(zone -> zone.detection().name()).toList();
    List<String> names = levelNames(plan);
    if (names.isEmpty() || asksForTwoStandards(plan)) {
      return Optional.empty();
    }
    CellClasses coverage = coverage(plan);
    double[] reached = coverage.values;
    Arrays.setAll(reached, cell -> 0 * reached[cell]); // NaN stays NaN: cells without a point
    List<Color> colors = new ArrayList<>(List.of(Palette.UNSEEN));
    List<String> labels = new ArrayList<>(List.of("none"));
    int[] levelsOfPoints = new int[plan.demand().points().size()];
    for (String name : names) {
      Detection detection = Detection.of(catalogue.detections().create(name));
      colors.add(Palette.SEQUENCE.get(labels.size() - 1));
      String suffix = asked.contains(detection.name()) ? " (asked for)" : "";
      labels.add(DensityDetections.levelName(name) + suffix);
      int[][] seen =
          new PointSight(plan.demand().with(detection), catalogue)
              .covered(plan.cameras(), plan.reading());
      int level = labels.size() - 1;
      Arrays.stream(seen)
          .flatMapToInt(Arrays::stream)
          .forEach(point -> levelsOfPoints[point] = level);
    }
    forEachPoint(
        plan.demand(),
        (cell, zone, point) -> reached[cell] = Math.max(reached[cell], levelsOfPoints[point]));
    return Optional.of(new CellClasses(coverage.cells, reached, colors, labels));
  }

  /** Whether zones ask for levels of more than one standard. */
  static boolean asksForTwoStandards(CameraPlan plan) {
    return levelNames(plan).size() > Palette.SEQUENCE.size();
  }

  private static List<String> levelNames(CameraPlan plan) {
    return plan.demand().zones().stream()
        .flatMap(zone -> DensityDetections.levels(zone.detection().name()).stream())
        .distinct()
        .toList();
  }
}
