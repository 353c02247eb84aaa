package org.hificamsim.network.statistics;

/**
 * Part of a circle.
 *
 * @param start mathematical angle of its first point, radians
 * @param extent radians, above 0
 */
record Arc(double cx, double cy, double radius, double start, double extent) implements Edge {
  private double angle(double t) {
    return start + extent * t;
  }

  @Override
  public double x(double t) {
    return cx + radius * Math.cos(angle(t));
  }

  @Override
  public double y(double t) {
    return cy + radius * Math.sin(angle(t));
  }

  @Override
  public double leftX(double t) {
    return -Math.cos(angle(t));
  }

  @Override
  public double leftY(double t) {
    return -Math.sin(angle(t));
  }

  @Override
  public double areaBetween(double from, double to) {
    return (radius * radius * extent * (to - from)
            + cx * (y(to) - y(from))
            - cy * (x(to) - x(from)))
        / 2;
  }

  @Override
  public void cross(Edge other, Cuts cuts) {
    if (other instanceof Arc arc) {
      crossCircle(arc.cx, arc.cy, arc.radius, cuts);
    } else if (other instanceof Side side) {
      crossLine(side.fromX(), side.fromY(), side.directionX(), side.directionY(), cuts);
    }
  }

  private void crossCircle(double ox, double oy, double other, Cuts cuts) {
    double distance = Math.hypot(ox - cx, oy - cy);
    if (distance == 0) {
      return;
    }
    double cosine =
        (radius * radius + distance * distance - other * other) / (2 * radius * distance);
    addAround(Math.atan2(oy - cy, ox - cx), cosine, cuts);
  }

  private void crossLine(double px, double py, double dx, double dy, Cuts cuts) {
    double away = (px - cx) * -dy + (py - cy) * dx;
    addAround(Math.atan2(dx, -dy), away / radius, cuts);
  }

  /** The two angles on either side of a direction that have this cosine with it, if any. */
  private void addAround(double direction, double cosine, Cuts cuts) {
    if (Math.abs(cosine) > 1) {
      return;
    }
    double half = Math.acos(cosine);
    addAngle(direction + half, cuts);
    addAngle(direction - half, cuts);
  }

  private void addAngle(double angle, Cuts cuts) {
    double turn = 2 * Math.PI;
    double from = (angle - start) % turn;
    cuts.add((from < 0 ? from + turn : from) / extent);
  }
}
