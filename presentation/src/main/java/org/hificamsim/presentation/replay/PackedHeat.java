package org.hificamsim.presentation.replay;

import java.io.IOException;
import java.io.OutputStream;
import java.util.Arrays;
import java.util.List;
import org.hificamsim.core.Spelling;
import org.hificamsim.runs.heat.HeatFigure;
import org.hificamsim.runs.heat.HeatMap;

/**
 * A heat map in few bytes, for a page.
 *
 * @param steps that it is of
 * @param first of these
 * @param areaCovered see {@link HeatMap#covered}; the next two as well
 * @param perUnit parts of a unit that figures are rounded to
 * @param figures what can be shown of it
 * @param data a {@link Series} for each figure: 0 for NaN, else zigzag + 1 of the number times
 *     {@code perUnit}; deflated (zlib), in Base64
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
   * How a figure of a map is shown.
   *
   * @param never what 0 says
   * @param end of its scale
   * @param logarithmic whether the scale is: from 1, not 0, to the end
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
    /** The figure as it is shown of a map. */
    public static ShownFigure of(HeatFigure figure, HeatMap map) {
      double end = figure.end(map);
      return new ShownFigure(
          Spelling.of(figure),
          figure.label(),
          figure.never(),
          map.cells().columns(),
          map.cells().rows(),
          end,
          figure.logarithmic(),
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
        Deflated.base64(Deflated.FAST, out -> pack(out, map)));
  }

  private static void pack(OutputStream out, HeatMap map) throws IOException {
    Scale scale = new Scale(PER_UNIT);
    for (HeatFigure figure : HeatFigure.values()) {
      Series.write(
          out, map.places().stream().mapToLong(place -> scale.packOptional(figure.of(place))));
    }
  }
}
