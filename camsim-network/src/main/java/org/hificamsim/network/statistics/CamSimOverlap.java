package org.hificamsim.network.statistics;

import org.hificamsim.core.scenario.spec.Field;

/**
 * CamSim's overlap of two cameras (behaviour 10.2, quirk Q11): two circle segments. It ignores
 * opening angles and is right for some positions only; it is kept for CamSim's numbers.
 *
 * @param field whose top left corner is CamSim's origin
 */
record CamSimOverlap(Field field) {
  /** Of two cameras, the first being earlier in the list, square metres. */
  double of(RangeCircle first, RangeCircle second) {
    return of(x(first), y(first), first.radius(), x(second), y(second), second.radius());
  }

  private double x(RangeCircle camera) {
    return camera.x() - field.minX();
  }

  private double y(RangeCircle camera) {
    return (field.minY() + camera.y()) * -1;
  }

  /** In square metres, of the camera at (x1, y1) with range a and a later one with range b. */
  static double of(double x1, double y1, double a, double x2, double y2, double b) {
    double dx = x1 - x2;
    double dy = y1 - y2;
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
    double qx = x1 + along * ex;
    double qy = y1 + along * ey;
    double upX = qx + across * -ey;
    double upY = qy + across * ex;
    double downX = qx - across * -ey;
    double downY = qy - across * ex;
    double first = opening(x1, y1, upX, upY, downX, downY, x2, y2);
    double second = opening(x2, y2, upX, upY, downX, downY, x1, y1);
    return segment(a, first) + segment(b, second);
  }

  private static double opening(
      double x,
      double y,
      double upX,
      double upY,
      double downX,
      double downY,
      double x2,
      double y2) {
    double up = degrees(x, y, upX, upY);
    double down = degrees(x, y, downX, downY);
    return Math.abs(Math.min(up, down) - degrees(x, y, x2, y2)) * 2;
  }

  /** The direction from one point to another, as CamSim computes it. */
  private static double degrees(double fromX, double fromY, double toX, double toY) {
    double dx = fromX - toX;
    double dy = fromY - toY;
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
