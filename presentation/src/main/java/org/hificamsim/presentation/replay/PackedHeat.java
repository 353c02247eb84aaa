package org.hificamsim.presentation.replay;

import java.io.IOException;
import java.io.OutputStream;
import java.util.Arrays;
import java.util.List;
import org.hificamsim.core.Spelling;
import org.hificamsim.runs.heat.HeatFigure;
import org.hificamsim.runs.heat.HeatMap;

/**
 * A heat map in few bytes, for pages.
 *
 * @param first the first step of the map
 * @param steps the number of steps of the map
 * @param areaCovered see {@link HeatMap#covered}
 * @param areaCoveredK see {@link HeatMap#coveredK}
 * @param areaBlind see {@link HeatMap#blind}
 * @param perUnit values are rounded to multiples of 1 / perUnit
 * @param figures the figures of the map that can be shown
 * @param data a {@link Series} for each figure, compressed (zlib) and in Base64. A value is 0 for
 *     NaN, else one more than the zigzag code of the number times {@code perUnit}
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
    List<ShownFigure> figures,
    String data) {
  private static final double PER_UNIT = 1e6; // as in heatmap.csv

  /**
   * The scale by which a figure of a map is shown.
   *
   * @param never words on what a value of 0 means
   * @param end the end of the scale
   * @param logarithmic whether the scale is logarithmic, from 1 instead of 0 to the end
   * @param least the start of the scale in words
   * @param most its end in words
   */
  public record ShownFigure(
      String name,
      String label,
      String never,
      int columns,
      int rows,
      double end,
      boolean logarithmic,
      String least,
      String most) {
    /** Returns a figure of a map. */
    public static ShownFigure of(HeatFigure figure, HeatMap map) {
      double end = figure.end(map);
      return new ShownFigure(
          Spelling.of(figure),
          figure.label(),
          figure.never(),
          map.cells().columns(),
          map.cells().rows(),
          end,
          figure.isLogarithmic(),
          figure.tick(figure.ticks(end).get(0)),
          figure.tick(end));
    }
  }

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
        Arrays.stream(HeatFigure.values()).map(figure -> ShownFigure.of(figure, map)).toList(),
        Deflated.base64(Deflated.FAST_LEVEL, out -> pack(out, map)));
  }

  private static void pack(OutputStream out, HeatMap map) throws IOException {
    Scale scale = new Scale(PER_UNIT);
    for (HeatFigure figure : HeatFigure.values()) {
      Series.write(
          out, map.places().stream().mapToLong(cell -> scale.packOptional(figure.figureOf(cell))));
    }
  }
}
