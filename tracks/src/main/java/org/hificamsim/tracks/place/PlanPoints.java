package org.hificamsim.tracks.place;

import org.hificamsim.core.Place;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.tracks.format.Unit;
import org.hificamsim.tracks.ground.LocalProjection;

/**
 * Converts the points of a file to metres, rounded to the millimetre.
 *
 * @param unit unit of the file
 * @param projection projection of degrees to metres
 */
record PlanPoints(Unit unit, LocalProjection projection) {
  private static final double PER_MILLIMETRE = 1e3;
  private static final double MAX_METRES = 1e9;

  Point point(Place place, double x, double y) {
    if (unit == Unit.DEG) {
      Point metres = projection.metres(place, x, y);
      return rounded(metres.x(), metres.y());
    }
    return checked(place, x * unit.metres(), y * unit.metres());
  }

  /** Rounds a point in metres, and refuses one that is out of range. */
  static Point checked(Place place, double x, double y) {
    if (!(Math.abs(x) <= MAX_METRES && Math.abs(y) <= MAX_METRES)) {
      throw place.error("a point is at %s, %s, expected numbers from -1e9 to 1e9", x, y);
    }
    return rounded(x, y);
  }

  static Point rounded(double x, double y) {
    return new Point(rounded(x), rounded(y));
  }

  private static double rounded(double metres) {
    return Math.rint(metres * PER_MILLIMETRE) / PER_MILLIMETRE + 0.0; // -0 becomes 0
  }
}
