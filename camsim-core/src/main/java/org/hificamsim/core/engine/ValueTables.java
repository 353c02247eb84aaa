package org.hificamsim.core.engine;

import java.util.Arrays;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DistanceTable;
import org.hificamsim.core.detection.ZoomLevel;

/** A model's values by distance for each row of a sight; made when they are first asked for. */
final class ValueTables {
  private final Detection detection;
  private ZoomLevel[] zooms = new ZoomLevel[1]; // of each entry
  private DistanceTable[] tables = new DistanceTable[1]; // of each entry

  ValueTables(Detection detection) {
    this.detection = detection;
  }

  /** Makes room for a row. */
  void add(ZoomLevel zoom, int row, int sizes) {
    int entries = row + sizes;
    if (entries > tables.length) {
      tables = Arrays.copyOf(tables, Math.max(entries, 2 * tables.length));
      zooms = Arrays.copyOf(zooms, tables.length);
    }
    Arrays.fill(zooms, row, entries, zoom);
  }

  /**
   * The value of a target at a distance, see {@link DistanceTable#value}; any number of threads may
   * ask.
   */
  double value(int entry, double size, double distance) {
    DistanceTable table = tables[entry];
    return (table == null ? make(entry, size) : table).value(distance);
  }

  /** Two threads that come at once find the same one. */
  private DistanceTable make(int entry, double size) {
    tables[entry] = detection.values(size, zooms[entry]);
    return tables[entry];
  }
}
