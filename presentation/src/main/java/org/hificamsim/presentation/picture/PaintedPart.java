package org.hificamsim.presentation.picture;

import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.Optional;

/**
 * The part of the plane in which lines are painted: a picture and what lies about it, since
 * painting a line takes as long as the line is, also where nobody sees it.
 *
 * @param bounds the picture with as much again on each side, so that no end of a stroke is seen
 */
record PaintedPart(Rectangle2D bounds) {
  /** About a part of a picture. */
  static PaintedPart of(Rectangle2D area) {
    return new PaintedPart(
        new Rectangle2D.Double(
            area.getX() - area.getWidth(),
            area.getY() - area.getHeight(),
            3 * area.getWidth(),
            3 * area.getHeight()));
  }

  /** The part of a line that lies within (Liang and Barsky 1984); the line itself if all does. */
  Optional<Line2D> within(Line2D line) {
    if (bounds.contains(line.getP1()) && bounds.contains(line.getP2())) {
      return Optional.of(line);
    }
    Part part = new Part(0, 1);
    double dx = line.getX2() - line.getX1();
    double dy = line.getY2() - line.getY1();
    part = part.where(-dx, line.getX1() - bounds.getMinX());
    part = part.where(dx, bounds.getMaxX() - line.getX1());
    part = part.where(-dy, line.getY1() - bounds.getMinY());
    part = part.where(dy, bounds.getMaxY() - line.getY1());
    return part.from >= part.to
        ? Optional.empty()
        : Optional.of(
            new Line2D.Double(
                line.getX1() + part.from * dx,
                line.getY1() + part.from * dy,
                line.getX1() + part.to * dx,
                line.getY1() + part.to * dy));
  }

  /** A part of a line, from 0, its start, to 1, its end; of no length where {@code from >= to}. */
  private record Part(double from, double to) {
    private static final Part NONE = new Part(1, 0);

    /** The part of this one where {@code rise * t <= room}. */
    Part where(double rise, double room) {
      if (rise == 0) {
        return room < 0 ? NONE : this;
      }
      return rise < 0
          ? new Part(Math.max(from, room / rise), to)
          : new Part(from, Math.min(to, room / rise));
    }
  }
}
