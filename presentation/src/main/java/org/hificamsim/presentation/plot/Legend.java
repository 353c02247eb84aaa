package org.hificamsim.presentation.plot;

import java.awt.Graphics2D;
import java.util.ArrayList;
import java.util.List;

/** Explains the signs of a picture by labels, which are arranged in rows. */
public final class Legend {
  private static final int SIGN_GAP = 6;
  private static final int ENTRY_GAP = 18;

  private record Place(LegendEntry entry, int x, int row) {}

  private final List<Place> places = new ArrayList<>();
  private final int signWidth;
  private final int rowHeight;
  private int rows;

  /**
   * @param groups the entries in groups, each of which starts a new row
   * @param width the width of the legend, in points
   */
  public Legend(List<List<LegendEntry>> groups, int width, int signWidth, int rowHeight) {
    this.signWidth = signWidth;
    this.rowHeight = rowHeight;
    for (List<LegendEntry> group : groups) {
      int x = 0;
      for (LegendEntry entry : group) {
        int entryWidth = textX(entry) + Fonts.width(entry.label(), Fonts.TEXT);
        if (x > 0 && x + entryWidth > width) {
          x = 0;
          rows++;
        }
        places.add(new Place(entry, x, rows));
        x += entryWidth + ENTRY_GAP;
      }
      rows += group.isEmpty() ? 0 : 1;
    }
  }

  private int textX(LegendEntry entry) {
    return entry.sign() == null ? 0 : signWidth + SIGN_GAP;
  }

  /** The height of the legend, in points. */
  public int height() {
    return rowHeight * rows;
  }

  /** Paints the legend with its upper left corner at a place. */
  public void paint(Graphics2D graphics, int left, int top) {
    for (Place place : places) {
      int x = left + place.x;
      int middle = top + place.row * rowHeight + rowHeight / 2;
      if (place.entry.sign() != null) {
        place.entry.sign().paint(graphics, x, middle);
      }
      graphics.setFont(Fonts.TEXT);
      graphics.setColor(Palette.BLACK);
      graphics.drawString(place.entry.label(), x + textX(place.entry), middle + 4);
    }
  }
}
