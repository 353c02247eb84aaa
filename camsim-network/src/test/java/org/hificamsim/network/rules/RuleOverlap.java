package org.hificamsim.network.rules;

/** The overlap of two circles by section 10.2 of docs/camsim-behaviour.md. */
final class RuleOverlap {
  private RuleOverlap() {}

  static double area(double[] p1, double a, double[] p2, double b) {
    double dx = p1[0] - p2[0];
    double dy = p1[1] - p2[1];
    double c = Math.sqrt(dx * dx + dy * dy);
    if (c == 0) {
      return 0;
    }
    double x = (a * a + c * c - b * b) / (2 * c);
    double squared = a * a - x * x;
    if (squared <= 0) {
      return 0;
    }
    double y = Math.sqrt(squared);
    double[] e = {Math.abs(dx) / c, Math.abs(dy) / c};
    double[] f = {-e[1], e[0]};
    double[] q = {p1[0] + x * e[0], p1[1] + x * e[1]};
    double[] i1 = {q[0] + y * f[0], q[1] + y * f[1]};
    double[] i2 = {q[0] - y * f[0], q[1] - y * f[1]};
    double theta1 = Math.abs(Math.min(angle(p1, i1), angle(p1, i2)) - angle(p1, p2)) * 2;
    double theta2 = Math.abs(Math.min(angle(p2, i1), angle(p2, i2)) - angle(p2, p1)) * 2;
    return segment(a, theta1) + segment(b, theta2);
  }

  private static double angle(double[] p, double[] z) {
    double dx = p[0] - z[0];
    double dy = p[1] - z[1];
    if (dx == 0) {
      return dy == 0 ? 0 : dy > 0 ? 90 : -90;
    }
    if (dy == 0) {
      return dx > 0 ? 180 : 0;
    }
    double degrees = Math.toDegrees(Math.atan(dy / dx)) + (dx > 0 ? 180 : 0);
    return degrees < 0 ? degrees + 360 : degrees;
  }

  private static double segment(double radius, double degrees) {
    double radians = Math.toRadians(degrees);
    return Math.abs(radius * radius / 2 * (radians - Math.sin(radians)));
  }
}
