package org.hificamsim.presentation.replay;

import java.io.IOException;
import java.io.OutputStream;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.hificamsim.runs.heat.HeatMap;
import org.hificamsim.runs.heat.HeatMap.Place;

/**
 * A heat map in few bytes, for a page.
 *
 * @param steps that it is of
 * @param first of these
 * @param areaCovered see {@link HeatMap#covered}; likewise the next two
 * @param perUnit parts of a unit that figures are rounded to
 * @param data a {@link Series} for each figure, in the order of {@link #FIGURES}: 0 for NaN, else
 *     zigzag + 1 of the number times {@code perUnit}; deflated (zlib), in Base64
 */
public record PackedHeat(
    int columns,
    int rows,
    long first,
    long steps,
    double areaCovered,
    double areaCoveredK,
    double areaBlind,
    double perUnit,
    String data) {
  private static final double PER_UNIT = 1e6; // as in heatmap.csv

  /** In the order in which the page's {@code heat.js} reads them. */
  private static final List<ToDoubleFunction<Place>> FIGURES =
      List.of(
          Place::meanK,
          Place::covered0,
          Place::coveredK,
          Place::visits,
          Place::visitsMeanK,
          Place::visitsCovered0);

  /** Packs a map. */
  public static PackedHeat of(HeatMap map, long first, long steps) {
    return new PackedHeat(
        map.cells().columns(),
        map.cells().rows(),
        first,
        steps,
        map.covered(),
        map.coveredK(),
        map.blind(),
        PER_UNIT,
        Deflated.base64(out -> pack(out, map)));
  }

  private static void pack(OutputStream out, HeatMap map) throws IOException {
    Scale scale = new Scale(PER_UNIT);
    for (ToDoubleFunction<Place> figure : FIGURES) {
      long before = 0;
      for (Place place : map.places()) {
        long code = scale.packOptional(figure.applyAsDouble(place));
        Series.write(out, code - before);
        before = code;
      }
    }
  }
}
