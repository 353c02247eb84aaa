package org.hificamsim.core.visibility;

import java.util.List;
import org.hificamsim.core.detection.VerticalView;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.obstacle.Point;

/**
 * The part of the ground on which a target stands in the picture of a lens from its lowest to its
 * greatest height: a trapezoid in front of the camera, possibly empty. By the pinhole projection at
 * a tilt T, with half angles H (horizontal) and V (vertical), a point a metres ahead, b to the
 * right and h below the camera is in the picture if
 *
 * <pre>
 * |b| &lt;= tan H (a cos T + h sin T)
 * a sin(T + V) &gt;= h cos(T + V)      (below it is the blind zone)
 * a sin(T - V) &lt;= h cos(T - V)      (above it the view ends)
 * </pre>
 *
 * <p>The border belongs to the footprint. All three conditions are linear, so the lowest and the
 * greatest height decide.
 *
 * @param near the least distance ahead, in metres; above {@code far} if the footprint is empty
 * @param far the greatest distance ahead, in metres; may be infinite
 * @param slope the slope of the sides: metres to the right for each metre ahead
 * @param offset the offset of the sides at the camera, metres to the right
 */
public record Footprint(double near, double far, double slope, double offset) {
  /**
   * Returns the footprint of a zoom level whose lens has a vertical angle.
   *
   * @param low the lowest height that must be in the picture, in metres
   * @param high the greatest height that must be in the picture, in metres
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

  /** Narrows the limits to distances a with {@code sign (a sin - below cos) >= 0}. */
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

  /** Whether a position is in the footprint: metres ahead of the camera, and to its right. */
  public boolean contains(double ahead, double right) {
    return ahead >= near && ahead <= far && Math.abs(right) <= slope * ahead + offset;
  }

  /** Whether the footprint has no point within a distance of the camera, in metres. */
  public boolean isEmpty(double reach) {
    return corners(reach).isEmpty();
  }

  /**
   * Returns the corners, metres to the right (x) and ahead (y), cut off at the reach; empty if
   * nothing is left. The two nearest corners coincide where the sides meet.
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
