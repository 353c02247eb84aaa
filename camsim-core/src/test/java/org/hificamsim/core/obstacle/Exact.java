package org.hificamsim.core.obstacle;

import java.math.BigDecimal;

/** Slow exact geometry with decimals of any length, independent of the tested formulas. */
final class Exact {
  private Exact() {}

  static boolean touches(Obstacle obstacle, Point a, Point b) {
    return obstacle instanceof Obstacle.Wall wall
        ? touch(a, b, new Point(wall.x1(), wall.y1()), new Point(wall.x2(), wall.y2()))
        : touches((Obstacle.Pillar) obstacle, a, b);
  }

  /** Whether two segments cross, or an end of one is on the other. */
  private static boolean touch(Point a, Point b, Point c, Point d) {
    boolean cross =
        orientation(a, b, c) * orientation(a, b, d) < 0
            && orientation(c, d, a) * orientation(c, d, b) < 0;
    return cross
        || isOnSegment(a, c, d)
        || isOnSegment(b, c, d)
        || isOnSegment(c, a, b)
        || isOnSegment(d, a, b);
  }

  private static boolean isOnSegment(Point point, Point from, Point to) {
    return orientation(from, to, point) == 0
        && isBetween(point.x(), from.x(), to.x())
        && isBetween(point.y(), from.y(), to.y());
  }

  private static boolean isBetween(double value, double a, double b) {
    return (value >= a || value >= b) && (value <= a || value <= b);
  }

  /** Compares the squared distance of the segment from the centre with the squared radius. */
  private static boolean touches(Obstacle.Pillar pillar, Point a, Point b) {
    BigDecimal dx = decimal(b.x()).subtract(decimal(a.x()));
    BigDecimal dy = decimal(b.y()).subtract(decimal(a.y()));
    BigDecimal fx = decimal(pillar.x()).subtract(decimal(a.x()));
    BigDecimal fy = decimal(pillar.y()).subtract(decimal(a.y()));
    BigDecimal square = dx.multiply(dx).add(dy.multiply(dy));
    BigDecimal along = fx.multiply(dx).add(fy.multiply(dy)).max(BigDecimal.ZERO).min(square);
    boolean point = square.signum() == 0;
    // The nearest point is a + along / square d; all terms are multiplied by the square.
    BigDecimal scale = point ? BigDecimal.ONE : square;
    BigDecimal gapX = fx.multiply(scale).subtract(along.multiply(dx));
    BigDecimal gapY = fy.multiply(scale).subtract(along.multiply(dy));
    BigDecimal reach = decimal(pillar.radius()).multiply(scale);
    return gapX.pow(2).add(gapY.pow(2)).compareTo(reach.pow(2)) <= 0;
  }

  /** The sign of the area of the triangle of three points, from its six products. */
  static int orientation(Point a, Point b, Point c) {
    return product(a.x(), b.y())
        .subtract(product(a.y(), b.x()))
        .add(product(b.x(), c.y()))
        .subtract(product(b.y(), c.x()))
        .add(product(c.x(), a.y()))
        .subtract(product(c.y(), a.x()))
        .signum();
  }

  private static BigDecimal product(double a, double b) {
    return decimal(a).multiply(decimal(b));
  }

  private static BigDecimal decimal(double value) {
    return new BigDecimal(value);
  }
}
