package org.hificamsim.presentation.picture;

import java.awt.Graphics2D;
import java.util.ArrayList;
import java.util.List;
import org.hificamsim.presentation.plot.Fonts;
import org.hificamsim.presentation.plot.Palette;

/** What the signs in a picture of a field mean, in lines: each group of signs begins a new one. */
final class SignLegend {
  private static final int LINE = 24;
  private static final int MARK = 16;
  private static final int GAP = 14;
  private static final double RADIUS = 5.5;

  private record Place(FieldScript.Sign sign, int x, int line) {}

  private final List<Place> places = new ArrayList<>();
  private int lines;

  /**
   * @param width points
   */
  SignLegend(List<List<FieldScript.Sign>> groups, int width) {
    for (List<FieldScript.Sign> group : groups) {
      int x = 0;
      for (FieldScript.Sign sign : group) {
        int room = (sign.mark() == null ? 0 : MARK) + Fonts.width(sign.label(), Fonts.TEXT);
        if (x > 0 && x + room > width) {
          x = 0;
          lines++;
        }
        places.add(new Place(sign, x, lines));
        x += room + GAP;
      }
      lines++;
    }
  }

  /** Its height, points. */
  int height() {
    return LINE * lines;
  }

  void paint(FieldScript script, Graphics2D graphics, int left, int top) {
    for (Place place : places) {
      int x = left + place.x;
      int middle = top + place.line * LINE + LINE / 2;
      if (place.sign.mark() != null) {
        script.paint(graphics, place.sign, x + RADIUS + 0.5, middle, RADIUS);
        x += MARK;
      }
      graphics.setFont(Fonts.TEXT);
      graphics.setColor(Palette.BLACK);
      graphics.drawString(place.sign.label(), x, middle + 4);
    }
  }
}
