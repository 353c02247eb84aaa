package org.hificamsim.presentation.plot;

import java.awt.Graphics2D;
import java.util.ArrayList;
import java.util.List;

/** Signs and what they mean, side by side in as many rows as they need. */
public final class Legend {
  private static final int GAP = 6;
  private static final int BETWEEN = 18;

  /** Paints a sign. */
  @FunctionalInterface
  public interface Sign {
    /**
     * @param x where its room begins
     * @param y its middle
     */
    void paint(Graphics2D graphics, int x, int y);
  }

  /**
   * @param sign null for a label alone
   */
  public record Entry(String label, Sign sign) {}

  private record Place(Entry entry, int x, int row) {}

  private final List<Place> places = new ArrayList<>();
  private final int signWidth;
  private final int rowHeight;
  private int rows;

  /**
   * @param groups each begins a row of its own
   * @param width of all, points
   */
  public Legend(List<List<Entry>> groups, int width, int signWidth, int rowHeight) {
    this.signWidth = signWidth;
    this.rowHeight = rowHeight;
    for (List<Entry> group : groups) {
      int x = 0;
      for (Entry entry : group) {
        int room = textX(entry) + Fonts.width(entry.label, Fonts.TEXT);
        if (x > 0 && x + room > width) {
          x = 0;
          rows++;
        }
        places.add(new Place(entry, x, rows));
        x += room + BETWEEN;
      }
      rows += group.isEmpty() ? 0 : 1;
    }
  }

  private int textX(Entry entry) {
    return entry.sign == null ? 0 : signWidth + GAP;
  }

  /** Its height, points. */
  public int height() {
    return rowHeight * rows;
  }

  /** Paints it below and to the right of a place. */
  public void paint(Graphics2D graphics, int left, int top) {
    for (Place place : places) {
      int x = left + place.x;
      int middle = top + place.row * rowHeight + rowHeight / 2;
      if (place.entry.sign != null) {
        place.entry.sign.paint(graphics, x, middle);
      }
      graphics.setFont(Fonts.TEXT);
      graphics.setColor(Palette.BLACK);
      graphics.drawString(place.entry.label, x + textX(place.entry), middle + 4);
    }
  }
}
