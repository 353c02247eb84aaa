package org.hificamsim.presentation.picture;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Area;
import org.hificamsim.presentation.plot.Palette;
import org.hificamsim.presentation.replay.CameraPose;
import org.hificamsim.presentation.replay.Interval;
import org.hificamsim.presentation.replay.Level;

/** Paints what cameras see in their views, and what walls keep from all of them. */
final class SightPainter {
  static final Color RANGE = Palette.BLUE;
  static final double RANGE_STRENGTH = 0.13;
  static final Color SHADOW = new Color(0x6B7785);
  static final double SHADOW_STRENGTH = 0.28;
  private static final double OUTLINE_STRENGTH = 0.55;
  private static final float[] DASHES = {5, 4};
  private static final float[] BLIND_DASHES = {2, 5};

  private final Graphics2D graphics;
  private final FieldMap map;
  private final Area unlit = new Area();
  private final Area lit = new Area();

  SightPainter(Graphics2D graphics, FieldMap map) {
    this.graphics = graphics;
    this.map = map;
  }

  /** The field of view as an outline, the ranges where a target is detected as areas. */
  void view(CameraPose pose, int view) {
    graphics.setColor(Palette.pale(RANGE, RANGE_STRENGTH));
    for (Interval interval : pose.level(view).detected()) {
      Area ring = new Area(map.sector(pose, view, interval.to()));
      ring.subtract(new Area(map.sector(pose, view, interval.from())));
      graphics.fill(inSight(pose, ring));
    }
    outline(pose, view, DASHES);
  }

  /** The view that a camera is on its way to, as an outline alone. */
  void blind(CameraPose pose, int view) {
    outline(pose, view, BLIND_DASHES);
  }

  /** How the outline of a blind camera's view is drawn. */
  static BasicStroke blindStroke() {
    return stroke(BLIND_DASHES);
  }

  private static BasicStroke stroke(float[] dashes) {
    return new BasicStroke(1, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 10, dashes, 0);
  }

  private void outline(CameraPose pose, int view, float[] dashes) {
    Shape sector = map.sector(pose, view, reach(pose, view));
    graphics.setStroke(stroke(dashes));
    graphics.setColor(Palette.pale(RANGE, OUTLINE_STRENGTH));
    graphics.draw(pose.visible().isEmpty() ? sector : cut(pose, new Area(sector)));
  }

  /** A lens reaches as far as it detects; a round view as its radius says. */
  private static double reach(CameraPose pose, int view) {
    Level level = pose.level(view);
    return pose.lenses().isEmpty()
        ? level.radius()
        : level.detected().stream().mapToDouble(Interval::to).max().orElse(level.radius());
  }

  private Shape inSight(CameraPose pose, Area range) {
    if (pose.visible().isEmpty()) {
      return range;
    }
    unlit.add(range);
    Area seen = cut(pose, range);
    lit.add(seen);
    return seen;
  }

  private Area cut(CameraPose pose, Area area) {
    Area seen = new Area(map.ring(pose.visible()));
    seen.intersect(area);
    return seen;
  }

  /** Where some camera of those that were painted would detect, and walls hide it from all. */
  void shadows() {
    if (!unlit.isEmpty()) {
      unlit.subtract(lit);
      graphics.setColor(Palette.pale(SHADOW, SHADOW_STRENGTH));
      graphics.fill(unlit);
    }
  }
}
