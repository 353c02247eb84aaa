package org.hificamsim.placement.site;

import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.Zone;
import org.hificamsim.runs.cells.FieldCells;

/**
 * Cuts zones into cells, whose centres are the points of a demand. A small zone gets smaller cells
 * than a large one, so that each has enough points and none has too many.
 *
 * @param least the least number of cells along the longer side of the field
 * @param most the greatest number of cells along the longer side of the field
 */
public record Sampling(int least, int most) {
  private static final int DEFAULT_CELLS = 60;

  /** The least number of points of a zone, unless it needs more cells than the greatest number. */
  private static final int MIN_POINTS = 100;

  /** Cells whose sizes suit each zone. */
  public static final Sampling BY_ZONE = new Sampling(DEFAULT_CELLS, FieldCells.MAX);

  /** Returns a sampling by which all zones have cells of the same size. */
  public static Sampling equal(int cells) {
    return new Sampling(cells, cells);
  }

  /** Returns the cells for a zone. */
  FieldCells cells(Zone zone, Field field) {
    return FieldCells.of(field, cellsAlongField(zone, field));
  }

  private int cellsAlongField(Zone zone, Field field) {
    Field bounds = zone.bounds(field);
    double longerSide = Math.max(field.width(), field.height());
    double needed = longerSide * Math.sqrt(MIN_POINTS / (bounds.width() * bounds.height()));
    return (int) Math.max(least, Math.min(most, Math.ceil(needed)));
  }

  /** Returns the cells of the zone of a site that needs the smallest ones. */
  public FieldCells finest(Scenario site) {
    List<Zone> zones = Zone.ofSite(site.zones());
    Stream<FieldCells> cells =
        zones.stream().filter(zone -> zone.weight() > 0).map(zone -> cells(zone, site.field()));
    return cells
        .min(Comparator.comparingDouble(FieldCells::width))
        .orElseGet(() -> FieldCells.of(site.field(), least));
  }
}
