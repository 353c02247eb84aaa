package org.hificamsim.placement.output;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import org.hificamsim.presentation.plot.Palette;

/**
 * A pattern of parallel lines that fills a shape.
 *
 * @param gap between lines along an axis, in points
 * @param slope 1 for lines that rise to the right, -1 for lines that fall
 */
record Hatching(Color color, double gap, int slope) {
  static final Hatching BLIND_ZONE = new Hatching(Palette.CAMERA, 5, 1);
  static final Hatching NOT_ASKED_FOR = new Hatching(new Color(0xcccccc), 7, -1);

  /** Fills a shape with lines. */
  static void paint(Graphics2D graphics, Shape shape, Hatching hatching) {
    Rectangle2D bounds = shape.getBounds2D();
    if (bounds.isEmpty()) {
      return;
    }
    Graphics2D inside = (Graphics2D) graphics.create();
    inside.clip(shape);
    inside.setColor(hatching.color);
    inside.setStroke(new BasicStroke(0.7f));
    double height = bounds.getHeight();
    double first = Math.floor((bounds.getX() - height) / hatching.gap) * hatching.gap;
    for (double x = first; x < bounds.getMaxX(); x += hatching.gap) {
      double start = hatching.slope > 0 ? bounds.getMaxY() : bounds.getY();
      double end = hatching.slope > 0 ? bounds.getY() : bounds.getMaxY();
      inside.draw(new Line2D.Double(x, start, x + height, end));
    }
    inside.dispose();
  }
}
