package org.hificamsim.network.statistics;

import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.spec.Field;

/**
 * CamSim's formula for the overlap of two cameras (behaviour 10.2, quirk Q11): the area of two
 * circle segments. It ignores opening angles and is correct for some positions only; it is kept
 * because CamSim's numbers depend on it.
 *
 * @param field the field, whose top left corner is CamSim's origin
 */
record CamSimOverlap(Field field) {
  /** The overlap of two cameras, of which the first is earlier in the list, in square metres. */
  double overlap(RangeCircle first, RangeCircle second) {
    return lensArea(inCamSim(first), inCamSim(second));
  }

  /** Returns the circle in CamSim's coordinates. */
  private RangeCircle inCamSim(RangeCircle circle) {
    double x = circle.x() - field.minX();
    double y = (field.minY() + circle.y()) * -1;
    return new RangeCircle(x, y, circle.radius());
  }

  /** The overlap of two circles in CamSim's coordinates, in square metres. */
  static double lensArea(RangeCircle first, RangeCircle second) {
    double a = first.radius();
    double b = second.radius();
    double dx = first.x() - second.x();
    double dy = first.y() - second.y();
    double distance = Math.sqrt(dx * dx + dy * dy);
    if (distance == 0) {
      return 0;
    }
    double along = (a * a + distance * distance - b * b) / (2 * distance);
    double squared = a * a - along * along;
    if (!(squared > 0)) {
      return 0;
    }
    double across = Math.sqrt(squared);
    double ex = Math.abs(dx) / distance;
    double ey = Math.abs(dy) / distance;
    double qx = first.x() + along * ex;
    double qy = first.y() + along * ey;
    Point up = new Point(qx + across * -ey, qy + across * ex);
    Point down = new Point(qx - across * -ey, qy - across * ex);
    Point firstCentre = new Point(first.x(), first.y());
    Point secondCentre = new Point(second.x(), second.y());
    return segment(a, opening(firstCentre, up, down, secondCentre))
        + segment(b, opening(secondCentre, up, down, firstCentre));
  }

  /** The opening angle of a circle segment, in degrees, seen from the centre of its circle. */
  private static double opening(Point centre, Point up, Point down, Point otherCentre) {
    double lesser = Math.min(degrees(centre, up), degrees(centre, down));
    return Math.abs(lesser - degrees(centre, otherCentre)) * 2;
  }

  /** The direction from one point to another, in degrees, as CamSim computes it. */
  private static double degrees(Point from, Point to) {
    double dx = from.x() - to.x();
    double dy = from.y() - to.y();
    if (dx == 0) {
      return dy == 0 ? 0 : dy > 0 ? 90 : -90;
    }
    if (dy == 0) {
      return dx > 0 ? 180 : 0;
    }
    double angle = Math.toDegrees(Math.atan(dy / dx)) + (dx > 0 ? 180 : 0);
    return angle < 0 ? angle + 360 : angle;
  }

  private static double segment(double radius, double degrees) {
    double angle = Math.toRadians(degrees);
    return Math.abs(radius * radius / 2 * (angle - Math.sin(angle)));
  }
}
