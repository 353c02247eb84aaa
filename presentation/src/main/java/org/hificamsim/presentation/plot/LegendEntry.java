package org.hificamsim.presentation.plot;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Polygon;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;

/** One line of a figure's legend. */
public record LegendEntry(String label, Color color, Mark mark) {
  static final int WIDTH = 22;
  private static final float[] DASHES = {5, 4};

  /** How the thing is drawn. */
  public enum Mark {
    LINE,
    DASHES,
    BAR,
    DOT,
    DIAMOND
  }

  /** The entry with its sign. */
  Legend.Entry entry() {
    return new Legend.Entry(label, this::paint);
  }

  private void paint(Graphics2D graphics, int x, int y) {
    int middle = x + WIDTH / 2;
    graphics.setColor(color);
    switch (mark) {
      case LINE -> line(graphics, x, y, new BasicStroke(2.5f));
      case DASHES ->
          line(
              graphics,
              x,
              y,
              new BasicStroke(2, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 10, DASHES, 0));
      case BAR -> graphics.fill(new Rectangle2D.Double(x + 4, y - 6, 14, 12));
      case DOT -> graphics.fill(new Ellipse2D.Double(middle - 4, y - 4, 8, 8));
      case DIAMOND ->
          graphics.fill(
              new Polygon(
                  new int[] {middle, middle + 5, middle, middle - 5},
                  new int[] {y - 5, y, y + 5, y},
                  4));
    }
  }

  private static void line(Graphics2D graphics, int x, int y, BasicStroke stroke) {
    graphics.setStroke(stroke);
    graphics.draw(new Line2D.Double(x, y, x + WIDTH, y));
  }
}
