package org.hificamsim.tracks.place;

import java.util.Map;

/** The values of $INSUNITS in a DXF. */
final class DxfUnits {
  private static final Map<Integer, Double> METRES =
      Map.ofEntries(
          Map.entry(1, 0.0254),
          Map.entry(2, 0.3048),
          Map.entry(3, 1609.344),
          Map.entry(4, 1e-3),
          Map.entry(5, 1e-2),
          Map.entry(6, 1.0),
          Map.entry(7, 1e3),
          Map.entry(8, 0.0254e-6),
          Map.entry(9, 0.0254e-3),
          Map.entry(10, 0.9144),
          Map.entry(13, 1e-6),
          Map.entry(14, 0.1),
          Map.entry(15, 10.0),
          Map.entry(16, 100.0),
          Map.entry(21, 1200.0 / 3937));

  private DxfUnits() {}

  /** The metres of a unit; NaN if there is none. */
  static double metres(int insertionUnits) {
    return METRES.getOrDefault(insertionUnits, Double.NaN);
  }
}
