package org.hificamsim.presentation.plot;

import java.awt.BasicStroke;
import java.awt.Color;
import java.util.List;
import org.knowm.xchart.style.markers.Marker;
import org.knowm.xchart.style.markers.SeriesMarkers;

/**
 * The colour, mark and dashes that distinguish a policy from all others, also in print without
 * colour.
 *
 * @param mark the mark at points of its lines
 * @param stroke the stroke of its lines, which has the dashes
 */
public record LineLook(Color color, Marker mark, BasicStroke stroke) {
  private static final float WIDTH = 2.2f;
  private static final List<Marker> MARKS =
      List.of(
          SeriesMarkers.CIRCLE,
          SeriesMarkers.SQUARE,
          SeriesMarkers.TRIANGLE_UP,
          SeriesMarkers.DIAMOND,
          SeriesMarkers.TRIANGLE_DOWN,
          SeriesMarkers.CROSS,
          SeriesMarkers.PLUS,
          SeriesMarkers.OVAL);
  private static final List<float[]> DASHES =
      List.of(new float[] {1, 0}, new float[] {8, 4}, new float[] {2, 3}, new float[] {9, 3, 2, 3});

  /** Returns the look of the i-th of several policies, in a colour. */
  public static LineLook of(int i, Color color) {
    return new LineLook(color, mark(i), stroke(DASHES.get(i % DASHES.size())));
  }

  /** Returns a solid line with dots. */
  public static LineLook solid(Color color) {
    return of(0, color);
  }

  /** Returns the look of the optimum and other references. */
  public static LineLook reference() {
    return new LineLook(Palette.BLACK, SeriesMarkers.NONE, stroke(new float[] {5, 4}));
  }

  /** Returns the i-th mark; marks repeat after the eighth. */
  public static Marker mark(int i) {
    return MARKS.get(i % MARKS.size());
  }

  private static BasicStroke stroke(float[] dashes) {
    return new BasicStroke(WIDTH, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 10, dashes, 0);
  }
}
