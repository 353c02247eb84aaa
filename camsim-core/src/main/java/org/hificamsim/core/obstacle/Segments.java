package org.hificamsim.core.obstacle;

/** Decides exactly whether two closed segments, which may be points, have a point in common. */
final class Segments {
  private Segments() {}

  static boolean touch(
      double ax, double ay, double bx, double by, double cx, double cy, double dx, double dy) {
    if (apart(ax, bx, cx, dx) || apart(ay, by, cy, dy)) {
      return false;
    }
    // If all four points are on one line, all orientations are 0, and the ranges above have
    // decided.
    return Orientation.of(ax, ay, bx, by, cx, cy) * Orientation.of(ax, ay, bx, by, dx, dy) <= 0
        && Orientation.of(cx, cy, dx, dy, ax, ay) * Orientation.of(cx, cy, dx, dy, bx, by) <= 0;
  }

  private static boolean apart(double a, double b, double c, double d) {
    return Math.max(a, b) < Math.min(c, d) || Math.max(c, d) < Math.min(a, b);
  }
}
