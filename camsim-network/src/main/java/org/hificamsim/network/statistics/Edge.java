package org.hificamsim.network.statistics;

import java.util.function.DoubleConsumer;

/**
 * A piece of the boundary of a field of view, walked through anticlockwise as its parameter goes
 * from 0 to 1, so that the inside is on the left.
 */
sealed interface Edge {
  double x(double t);

  double y(double t);

  /** The x component of the unit vector to the left. */
  double leftX(double t);

  /** The y component of the unit vector to the left. */
  double leftY(double t);

  /** Half the integral of x dy - y dx from one parameter to another: its share of an area. */
  double areaBetween(double from, double to);

  /** Passes on the parameters at which it crosses the circle or line that another is part of. */
  void cross(Edge other, DoubleConsumer cuts);

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
    public void cross(Edge other, DoubleConsumer cuts) {
      if (other instanceof Side side) {
        double cosine = -side.leftward(cx, cy) / radius;
        addAround(Math.atan2(side.directionX, -side.directionY), cosine, cuts);
      } else if (other instanceof Arc arc) {
        double distance = Math.hypot(arc.cx - cx, arc.cy - cy);
        if (distance > 0) {
          double cosine =
              (radius * radius + distance * distance - arc.radius * arc.radius)
                  / (2 * radius * distance);
          addAround(Math.atan2(arc.cy - cy, arc.cx - cx), cosine, cuts);
        }
      }
    }

    /** The two angles on either side of a direction that have this cosine with it, if any. */
    private void addAround(double direction, double cosine, DoubleConsumer cuts) {
      if (Math.abs(cosine) <= 1) {
        double half = Math.acos(cosine);
        addAngle(direction + half, cuts);
        addAngle(direction - half, cuts);
      }
    }

    private void addAngle(double angle, DoubleConsumer cuts) {
      double turn = 2 * Math.PI;
      double from = (angle - start) % turn;
      cuts.accept((from < 0 ? from + turn : from) / extent);
    }
  }

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

    /** How far a point lies to the left. */
    private double leftward(double x, double y) {
      return (x - fromX) * -directionY + (y - fromY) * directionX;
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
    public void cross(Edge other, DoubleConsumer cuts) {
      if (other instanceof Side side) {
        double across = directionX * side.directionY - directionY * side.directionX;
        if (across != 0) {
          double away = (side.fromX - fromX) * side.directionY;
          cuts.accept((away - (side.fromY - fromY) * side.directionX) / across / length);
        }
      } else if (other instanceof Arc arc) {
        double along = (arc.cx() - fromX) * directionX + (arc.cy() - fromY) * directionY;
        double away = leftward(arc.cx(), arc.cy());
        double squared = arc.radius() * arc.radius() - away * away;
        if (squared >= 0) {
          cuts.accept((along - Math.sqrt(squared)) / length);
          cuts.accept((along + Math.sqrt(squared)) / length);
        }
      }
    }
  }
}
