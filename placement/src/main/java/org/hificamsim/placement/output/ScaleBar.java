package org.hificamsim.placement.output;

import java.awt.BasicStroke;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import org.hificamsim.core.Texts;
import org.hificamsim.presentation.plot.Fonts;
import org.hificamsim.presentation.plot.Palette;

/**
 * Shows the scale of a plan by a bar of a round length, and the north, which is +y, by an arrow.
 */
final class ScaleBar {
  private static final double LONGEST_SHARE = 0.25;
  private static final int HALF_TICK = 4;

  private ScaleBar() {}

  /**
   * Paints bar and arrow below a plan.
   *
   * @param area the place of the plan
   * @param scale points per metre
   */
  static void paint(Graphics2D graphics, Rectangle2D area, double scale) {
    double metres = roundLength(LONGEST_SHARE * area.getWidth() / scale);
    double left = area.getX();
    double right = left + metres * scale;
    double y = area.getMaxY() + 16;
    graphics.setColor(Palette.BLACK);
    graphics.setStroke(new BasicStroke(1.5f));
    graphics.draw(new Line2D.Double(left, y, right, y));
    for (double x : new double[] {left, right}) {
      graphics.draw(new Line2D.Double(x, y - HALF_TICK, x, y + HALF_TICK));
    }
    graphics.setFont(Fonts.TEXT);
    String text = Texts.format(metres < 1 ? "%.1f m" : "%.0f m", metres);
    graphics.drawString(text, (float) right + 8, (float) y + 4);
    paintNorth(graphics, area.getMaxX() - 10, y);
  }

  /** Returns the greatest number not above a limit that is 1, 2 or 5 times a power of ten. */
  private static double roundLength(double longest) {
    double power = Math.pow(10, Math.floor(Math.log10(longest)));
    return longest >= 5 * power ? 5 * power : longest >= 2 * power ? 2 * power : power;
  }

  private static void paintNorth(Graphics2D graphics, double x, double y) {
    Path2D arrow = new Path2D.Double();
    arrow.moveTo(x, y - 10);
    arrow.lineTo(x + 5, y + 8);
    arrow.lineTo(x, y + 4);
    arrow.lineTo(x - 5, y + 8);
    arrow.closePath();
    graphics.fill(arrow);
    graphics.drawString("N", (float) x - 20, (float) y + 5);
  }
}
