package epics.camsim.core;

/** A point of the plane, metres. */
final class Place {
  final double x;
  final double y;

  Place(double x, double y) {
    this.x = x;
    this.y = y;
  }
}
