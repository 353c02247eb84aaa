package org.hificamsim.presentation.plot;

import java.util.ArrayList;
import java.util.List;

/**
 * Where each entry of a legend stands: side by side, in as many rows as they need.
 *
 * @param rows 0 for an empty legend
 */
record LegendLayout(List<Place> places, int rows) {
  static final int MARK = 22;
  private static final int GAP = 6;
  private static final int BETWEEN = 18;

  /** An entry's left edge, and its row from 0. */
  record Place(LegendEntry entry, int x, int row) {
    int textX() {
      return x + MARK + GAP;
    }
  }

  static LegendLayout of(Figure figure) {
    List<Place> places = new ArrayList<>();
    int x = Figure.MARGIN;
    int row = 0;
    for (LegendEntry entry : figure.legend()) {
      int width = MARK + GAP + Fonts.width(entry.label(), Fonts.TEXT);
      if (x > Figure.MARGIN && x + width > figure.width() - Figure.MARGIN) {
        x = Figure.MARGIN;
        row++;
      }
      places.add(new Place(entry, x, row));
      x += width + BETWEEN;
    }
    return new LegendLayout(places, places.isEmpty() ? 0 : row + 1);
  }
}
