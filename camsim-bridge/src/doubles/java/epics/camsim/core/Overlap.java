package epics.camsim.core;

/**
 * Computes the area that the circles of two cameras have in common as CamSim does, which is right
 * for some positions only.
 */
final class Overlap {
  private Overlap() {}

  static double of(SimCore world, CameraController first, CameraController second) {
    Point p1 = new Point(first.left(world), first.top(world));
    Point p2 = new Point(second.left(world), second.top(world));
    double a = first.getRange();
    double b = second.getRange();
    double dx = p1.x - p2.x;
    double dy = p1.y - p2.y;
    double c = Math.sqrt(dx * dx + dy * dy);
    double along = (a * a + c * c - b * b) / (2 * c);
    double square = a * a - along * along;
    if (c == 0 || square <= 0) {
      return 0;
    }
    double across = Math.sqrt(square);
    double ex = Math.abs(dx) / c;
    double ey = Math.abs(dy) / c;
    Point q = new Point(p1.x + along * ex, p1.y + along * ey);
    Point one = new Point(q.x + across * -ey, q.y + across * ex);
    Point two = new Point(q.x - across * -ey, q.y - across * ex);
    return segment(a, opening(p1, p2, one, two)) + segment(b, opening(p2, p1, one, two));
  }

  private static double opening(Point from, Point other, Point one, Point two) {
    return Math.abs(Math.min(angle(from, one), angle(from, two)) - angle(from, other)) * 2;
  }

  private static double segment(double radius, double degrees) {
    double radians = Math.toRadians(degrees);
    return Math.abs(radius * radius / 2 * (radians - Math.sin(radians)));
  }

  private static double angle(Point from, Point to) {
    double dx = from.x - to.x;
    double dy = from.y - to.y;
    double degrees;
    if (dx == 0) {
      degrees = dy == 0 ? 0 : dy > 0 ? 90 : -90;
    } else if (dy == 0) {
      degrees = dx > 0 ? 180 : 0;
    } else {
      degrees = Math.toDegrees(Math.atan(dy / dx)) + (dx > 0 ? 180 : 0);
    }
    return degrees < 0 ? degrees + 360 : degrees;
  }
}
