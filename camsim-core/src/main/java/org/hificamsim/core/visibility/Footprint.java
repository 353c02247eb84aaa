package org.hificamsim.core.visibility;

import java.util.List;
import org.hificamsim.core.detection.VerticalView;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.obstacle.Point;

/**
 * Where on the ground an upright line stands whose part between two heights is all in the picture
 * of a lens: a trapezoid before the camera, or nothing. A point a ahead and b to the right of the
 * camera, h below it, is in the picture where, by the pinhole's projection at a tilt T, with half
 * angles H across and V up and down,
 *
 * <pre>
 * |b| &lt;= tan H (a cos T + h sin T)
 * a sin(T + V) &gt;= h cos(T + V)      (below it is the blind zone)
 * a sin(T - V) &lt;= h cos(T - V)      (above it the view ends)
 * </pre>
 *
 * <p>The border belongs to it. As all three are linear, both ends of the line decide.
 *
 * @param near the least distance ahead, metres; above {@code far} where it is empty
 * @param far the greatest; may be infinite
 * @param slope of the sides: metres to the right for each metre ahead
 * @param offset of the sides at the camera, metres to the right
 */
public record Footprint(double near, double far, double slope, double offset) {
  /**
   * Of a level that has a lens with a vertical angle.
   *
   * @param low the least height of what has to be in the picture, metres
   * @param high the greatest
   */
  public static Footprint of(ZoomLevel zoom, double low, double high) {
    VerticalView vertical = zoom.vertical();
    double half = StrictMath.tan(zoom.angleOfView() / 2);
    double sine = StrictMath.sin(vertical.tilt());
    double[] limits = {Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY};
    for (double height : new double[] {low, high}) {
      double below = vertical.z() - height;
      limit(limits, vertical.tilt() + vertical.angle() / 2, below, 1);
      limit(limits, vertical.tilt() - vertical.angle() / 2, below, -1);
    }
    return new Footprint(
        limits[0],
        limits[1],
        half * StrictMath.cos(vertical.tilt()),
        half * Math.min((vertical.z() - low) * sine, (vertical.z() - high) * sine));
  }

  /** Keeps what is ahead by a with {@code sign (a sin - below cos) >= 0}. */
  private static void limit(double[] limits, double angle, double below, int sign) {
    double sine = sign * StrictMath.sin(angle);
    double cosine = sign * StrictMath.cos(angle) * below;
    if (sine > 0) {
      limits[0] = Math.max(limits[0], cosine / sine);
    } else if (sine < 0) {
      limits[1] = Math.min(limits[1], cosine / sine);
    } else if (cosine > 0) {
      limits[0] = Double.POSITIVE_INFINITY;
    }
  }

  /** Whether a place is in it: metres ahead of the camera, and to its right. */
  public boolean contains(double ahead, double right) {
    return ahead >= near && ahead <= far && Math.abs(right) <= slope * ahead + offset;
  }

  /** Whether it has no point within a distance of the camera, metres. */
  public boolean isEmpty(double reach) {
    return corners(reach).isEmpty();
  }

  /**
   * Its corners, metres to the right (x) and ahead (y), cut where it is farther ahead than the
   * reach; none where nothing is left. The nearest two are one where the sides meet.
   */
  public List<Point> corners(double reach) {
    double tip = slope > 0 ? -offset / slope : offset >= 0 ? near : Double.POSITIVE_INFINITY;
    double from = Math.max(Math.max(near, tip), -reach);
    double to = Math.min(far, reach);
    return !(from <= to)
        ? List.of()
        : List.of(
            new Point(-side(from), from),
            new Point(side(from), from),
            new Point(side(to), to),
            new Point(-side(to), to));
  }

  private double side(double ahead) {
    return Math.max(0, slope * ahead + offset);
  }
}
