package org.hificamsim.network.statistics;

/**
 * A straight piece of a boundary.
 *
 * @param directionX of the unit vector along it
 */
record Side(double fromX, double fromY, double directionX, double directionY, double length)
    implements Edge {
  static Side between(double fromX, double fromY, double toX, double toY) {
    double length = Math.hypot(toX - fromX, toY - fromY);
    return new Side(fromX, fromY, (toX - fromX) / length, (toY - fromY) / length, length);
  }

  @Override
  public double x(double t) {
    return fromX + directionX * length * t;
  }

  @Override
  public double y(double t) {
    return fromY + directionY * length * t;
  }

  @Override
  public double leftX(double t) {
    return -directionY;
  }

  @Override
  public double leftY(double t) {
    return directionX;
  }

  @Override
  public double areaBetween(double from, double to) {
    return (x(from) * y(to) - x(to) * y(from)) / 2;
  }

  @Override
  public void cross(Edge other, Cuts cuts) {
    if (other instanceof Arc arc) {
      crossCircle(arc.cx(), arc.cy(), arc.radius(), cuts);
    } else if (other instanceof Side side) {
      crossLine(side.fromX, side.fromY, side.directionX, side.directionY, cuts);
    }
  }

  private void crossCircle(double cx, double cy, double radius, Cuts cuts) {
    double along = (cx - fromX) * directionX + (cy - fromY) * directionY;
    double away = (cx - fromX) * -directionY + (cy - fromY) * directionX;
    double squared = radius * radius - away * away;
    if (squared >= 0) {
      cuts.add((along - Math.sqrt(squared)) / length);
      cuts.add((along + Math.sqrt(squared)) / length);
    }
  }

  private void crossLine(double px, double py, double dx, double dy, Cuts cuts) {
    double across = directionX * dy - directionY * dx;
    if (across != 0) {
      cuts.add(((px - fromX) * dy - (py - fromY) * dx) / across / length);
    }
  }
}
