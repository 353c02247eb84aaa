package org.hificamsim.presentation.picture;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.stream.IntStream;
import org.hificamsim.presentation.plot.Fonts;
import org.hificamsim.presentation.plot.Palette;

/** What the colours of a heat map mean: a bar with numbers, and what has a colour of its own. */
final class HeatLegend {
  /** Its height, points. */
  static final int HEIGHT = 58;

  private static final int BAR_WIDTH = 300;
  private static final int BAR_HEIGHT = 12;
  private static final int GAP = 26;

  private final Graphics2D graphics;
  private final HeatLayer layer;

  HeatLegend(Graphics2D graphics, HeatLayer layer) {
    this.graphics = graphics;
    this.layer = layer;
  }

  /**
   * @param left of the bar, points
   * @param top of the line above the bar, points
   */
  void paint(double left, double top) {
    double bar = top + 18;
    text(layer.figure().label(), left, top + 11, Palette.BLACK);
    for (int i = 0; i < BAR_WIDTH; i++) {
      graphics.setColor(onWhite(Palette.scale((i + 0.5) / BAR_WIDTH)));
      graphics.fill(new Rectangle2D.Double(left + i, bar, Math.min(2, BAR_WIDTH - i), BAR_HEIGHT));
    }
    ticks(left, bar + BAR_HEIGHT);
    if (!layer.map().places().stream().allMatch(place -> layer.figure().of(place) != 0)) {
      never(left + BAR_WIDTH + GAP, bar);
    }
  }

  private void ticks(double left, double below) {
    graphics.setStroke(new BasicStroke(0.8f));
    for (double tick : layer.figure().ticks(layer.end())) {
      double x = left + BAR_WIDTH * layer.figure().share(tick, layer.end());
      graphics.setColor(FieldPainter.FAINT);
      graphics.draw(new Line2D.Double(x, below, x, below + 4));
      String words = layer.figure().tick(tick);
      double start = Math.max(left, x - Fonts.width(words, Fonts.TEXT) / 2.0);
      text(words, start, below + 16, FieldPainter.INK);
    }
  }

  private void never(double left, double top) {
    Rectangle2D box = new Rectangle2D.Double(left, top, 2 * BAR_HEIGHT, BAR_HEIGHT);
    Shape before = graphics.getClip();
    graphics.clip(box);
    graphics.setColor(Palette.pale(HeatLayer.NEVER, HeatLayer.NEVER_GROUND));
    graphics.fill(box);
    graphics.setColor(pale(HeatLayer.NEVER));
    graphics.setStroke(new BasicStroke(1));
    for (double x = left - BAR_HEIGHT; x < box.getMaxX(); x += BAR_HEIGHT / 2.0) {
      graphics.draw(new Line2D.Double(x, box.getMaxY(), x + BAR_HEIGHT, top));
    }
    graphics.setClip(before);
    text(layer.figure().never(), box.getMaxX() + 6, top + BAR_HEIGHT - 2, Palette.BLACK);
  }

  /** Opaque, so that there are no seams. */
  private static Color onWhite(Color color) {
    int[] parts =
        IntStream.of(color.getRed(), color.getGreen(), color.getBlue())
            .map(part -> (int) Math.round(255 - HeatLayer.STRENGTH * (255 - part)))
            .toArray();
    return new Color(parts[0], parts[1], parts[2]);
  }

  private static Color pale(Color color) {
    return Palette.pale(color, HeatLayer.STRENGTH);
  }

  private void text(String words, double x, double y, Color color) {
    graphics.setFont(Fonts.TEXT);
    graphics.setColor(color);
    graphics.drawString(words, (float) x, (float) y);
  }
}
