package org.hificamsim.presentation.picture;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Area;
import java.util.List;
import org.hificamsim.core.Spelling;
import org.hificamsim.hifi.density.Dori;
import org.hificamsim.presentation.plot.Fonts;
import org.hificamsim.presentation.plot.Palette;
import org.hificamsim.presentation.replay.CameraPose;

/**
 * How much of a camera's picture a metre takes, in the zones of EN 62676-4:2014: those of the
 * page's {@code density.js}. Pale is far, as one shade differs from the next for every eye.
 */
enum DensityZone {
  DETECT(Dori.DETECT, 0xE7B7D3),
  OBSERVE(Dori.OBSERVE, 0xCC79A7),
  RECOGNISE(Dori.RECOGNISE, 0x96487A),
  IDENTIFY(Dori.IDENTIFY, 0x56204A);

  private static final List<DensityZone> NEAREST_FIRST =
      List.of(IDENTIFY, RECOGNISE, OBSERVE, DETECT);
  private static final double STRENGTH = 0.6;

  private final String label;
  private final double density;
  private final Color color;

  DensityZone(Dori task, int rgb) {
    this.label = Spelling.of(task);
    this.density = task.pixelsPerMetre(); // at least
    this.color = new Color(rgb);
  }

  /** Name and least density. */
  String label() {
    return label + " " + (density % 1 == 0 ? Integer.toString((int) density) : "" + density);
  }

  Color color() {
    return color;
  }

  /** How far the zone reaches in a view, metres; 0 where the density is not known. */
  double reach(CameraPose pose, int view) {
    return pose.density(view) / density;
  }

  /** Paints all zones of a camera in a view, each with its name where it ends. */
  static void paint(Graphics2D graphics, FieldMap map, CameraPose pose, int view) {
    double from = 0;
    for (DensityZone zone : NEAREST_FIRST) {
      double to = zone.reach(pose, view);
      Area band = map.band(pose, view, from, to);
      from = to;
      graphics.setColor(Palette.pale(zone.color, STRENGTH));
      graphics.fill(band);
      graphics.setColor(zone.color.darker());
      graphics.setStroke(new BasicStroke(1));
      graphics.draw(band);
    }
    graphics.setFont(Fonts.TICKS);
    graphics.setColor(FieldPainter.INK);
    for (DensityZone zone : values()) {
      zone.name(graphics, map, pose, view);
    }
  }

  private void name(Graphics2D graphics, FieldMap map, CameraPose pose, int view) {
    double reach = reach(pose, view);
    double x = map.x(pose.x() + reach * Math.sin(pose.heading(view)));
    double y = map.y(pose.y() + reach * Math.cos(pose.heading(view)));
    graphics.drawString(label, (float) x - Fonts.width(label, Fonts.TICKS) / 2f, (float) y);
  }
}
