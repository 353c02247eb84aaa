package org.hificamsim.presentation.plot;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Polygon;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import org.knowm.xchart.style.markers.Marker;

/**
 * A sign in a picture with its label.
 *
 * @param sign the sign; null for a heading, which has none
 */
public record LegendEntry(String label, Sign sign) {
  static final int WIDTH = 22;
  private static final int MARK_SIZE = 8;
  private static final float[] DASHES = {5, 4};

  /** Paints a sign. */
  @FunctionalInterface
  public interface Sign {
    /**
     * Paints the sign.
     *
     * @param x its left end
     * @param y its middle
     */
    void paint(Graphics2D graphics, int x, int y);
  }

  /** The kinds of signs of figures. */
  public enum Mark {
    LINE,
    DASHES,
    BAR,
    DOT,
    DIAMOND
  }

  /** Creates an entry with a sign of some kind. */
  public LegendEntry(String label, Color color, Mark mark) {
    this(label, (graphics, x, y) -> paint(graphics, x, y, color, mark));
  }

  /** Returns an entry whose sign is a piece of a line with its mark. */
  public static LegendEntry of(String label, LineLook look) {
    return new LegendEntry(
        label,
        (graphics, x, y) -> {
          graphics.setColor(look.color());
          line(graphics, x, y, look.stroke());
          paint(graphics, x, y, look.color(), look.mark());
        });
  }

  /** Returns an entry whose sign is only a mark. */
  public static LegendEntry of(String label, Color color, Marker mark) {
    return new LegendEntry(label, (graphics, x, y) -> paint(graphics, x, y, color, mark));
  }

  private static void paint(Graphics2D graphics, int x, int y, Color color, Marker mark) {
    graphics.setStroke(new BasicStroke(1));
    graphics.setColor(color);
    mark.paint(graphics, x + WIDTH / 2.0, y, MARK_SIZE);
  }

  private static void paint(Graphics2D graphics, int x, int y, Color color, Mark mark) {
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
