package org.hificamsim.presentation.picture;

import java.awt.AlphaComposite;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Composite;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.presentation.plot.Palette;
import org.hificamsim.presentation.replay.Setup;

/** Paints what stands in the field besides cameras and targets, and the picture under it. */
final class SitePainter {
  static final Color WALL = new Color(0x1D2733);
  private static final float WALL_WIDTH = 3;
  private static final float[] THROUGH = {6, 3};

  private final Graphics2D graphics;
  private final FieldMap map;

  SitePainter(Graphics2D graphics, FieldMap map) {
    this.graphics = graphics;
    this.map = map;
  }

  /**
   * Paints the pictures under the field.
   *
   * @param opacity in [0, 1]
   */
  void floor(RunFrames run, double opacity) {
    if (run.floor().isEmpty()) {
      return;
    }
    Composite before = graphics.getComposite();
    graphics.setComposite(AlphaComposite.getInstance(AlphaComposite.SRC_OVER, (float) opacity));
    graphics.setRenderingHint(
        RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
    for (int i = 0; i < run.floor().size(); i++) {
      Rectangle2D area = map.rectangle(run.setup().floor().get(i).area());
      graphics.drawImage(
          run.floor().get(i),
          (int) Math.round(area.getX()),
          (int) Math.round(area.getY()),
          (int) Math.round(area.getWidth()),
          (int) Math.round(area.getHeight()),
          null);
    }
    graphics.setComposite(before);
  }

  /** Paints walls, polygons and pillars; what lets light through is paler and dashed. */
  void obstacles(Setup setup) {
    for (Obstacle obstacle : setup.obstacles()) {
      boolean wall = obstacle instanceof Obstacle.Wall;
      paint(graphics, map.shape(obstacle), wall ? WALL_WIDTH : 1, obstacle.transmittance());
    }
  }

  /** Paints a shape as one that lets a part of the light through. */
  static void paint(Graphics2D graphics, Shape shape, double transmittance) {
    paint(graphics, shape, 1, transmittance);
  }

  private static void paint(Graphics2D graphics, Shape shape, float width, double transmittance) {
    if (!(shape instanceof Line2D)) {
      graphics.setColor(Palette.pale(WALL, strength(transmittance)));
      graphics.fill(shape);
    }
    graphics.setColor(WALL);
    graphics.setStroke(stroke(width, transmittance == 0));
    graphics.draw(shape);
  }

  private static double strength(double transmittance) {
    return transmittance == 0 ? 0.65 : 0.05 + 0.25 * (1 - transmittance);
  }

  private static BasicStroke stroke(float width, boolean solid) {
    return solid
        ? new BasicStroke(width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND)
        : new BasicStroke(width, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 10, THROUGH, 0);
  }
}
