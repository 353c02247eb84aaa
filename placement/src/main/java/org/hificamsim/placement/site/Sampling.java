package org.hificamsim.placement.site;

import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.Zone;
import org.hificamsim.runs.cells.FieldCells;

/**
 * How finely zones are cut into cells, whose centres are the points of a demand. A small zone gets
 * smaller cells than a large one, so that each has enough points and none has too many.
 *
 * @param least the least number of cells along the longer side of the field
 * @param most the greatest number of cells along the longer side of the field
 */
public record Sampling(int least, int most) {
  private static final int DEFAULT_CELLS = 60;

  /** A zone has at least so many points, if the greatest number of cells allows it. */
  private static final int MIN_POINTS = 100;

  /** What suits each zone. */
  public static final Sampling BY_ZONE = new Sampling(DEFAULT_CELLS, FieldCells.MAX);

  /** The same number of cells along the field for all zones. */
  public static Sampling equal(int cells) {
    return new Sampling(cells, cells);
  }

  /** The cells for a zone. */
  FieldCells cells(Zone zone, Field field) {
    return FieldCells.of(field, along(zone, field));
  }

  private int along(Zone zone, Field field) {
    Field bounds = zone.bounds(field);
    double longerSide = Math.max(field.width(), field.height());
    double needed = longerSide * Math.sqrt(MIN_POINTS / (bounds.width() * bounds.height()));
    return (int) Math.max(least, Math.min(most, Math.ceil(needed)));
  }

  /** The cells for all zones of a site alike: those of the zone that needs the smallest. */
  public FieldCells finest(Scenario site) {
    List<Zone> zones = Zone.ofSite(site.zones());
    Stream<FieldCells> cells =
        zones.stream().filter(zone -> zone.weight() > 0).map(zone -> cells(zone, site.field()));
    return cells
        .min(Comparator.comparingDouble(FieldCells::width))
        .orElseGet(() -> FieldCells.of(site.field(), least));
  }
}
