package epics.camsim.core;

/** A point of the plane, in metres. */
final class Point {
  final double x;
  final double y;

  Point(double x, double y) {
    this.x = x;
    this.y = y;
  }
}
