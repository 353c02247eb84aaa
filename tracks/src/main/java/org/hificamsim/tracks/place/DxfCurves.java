package org.hificamsim.tracks.place;

import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.Arc2D;
import java.awt.geom.Path2D;
import java.util.Arrays;
import java.util.List;

/** The curves of a DXF, with y upwards and angles counterclockwise. */
final class DxfCurves {
  /** The bulge below which an arc is straight: the arc's height as a part of half its chord. */
  private static final double STRAIGHT = 1e-6;

  private static final int STEPS_PER_SPAN = 16;
  private static final int MAX_DEGREE = 25;

  private DxfCurves() {}

  /**
   * Returns an arc of a circle.
   *
   * @param start the start angle in degrees
   * @param sweep the swept angle in degrees, positive counterclockwise
   */
  static Shape arc(double x, double y, double radius, double start, double sweep) {
    return new Arc2D.Double(
        x - radius,
        y - radius,
        2 * radius,
        2 * radius,
        -start,
        -sweep,
        Arc2D.OPEN); // Arc2D has y downwards
  }

  /**
   * Returns a polyline.
   *
   * @param corners x, y and the bulge of the edge that begins at each corner: the tangent of a
   *     quarter of the angle of its arc, positive counterclockwise
   */
  static Shape polyline(List<double[]> corners, boolean isClosed) {
    Path2D path = new Path2D.Double();
    for (int i = 0; i < corners.size(); i++) {
      double[] corner = corners.get(i);
      if (i == 0) {
        path.moveTo(corner[0], corner[1]);
      }
      if (i + 1 < corners.size() || isClosed) {
        addEdge(path, corner, corners.get((i + 1) % corners.size()));
      }
    }
    if (isClosed && !corners.isEmpty()) {
      path.closePath();
    }
    return path;
  }

  private static void addEdge(Path2D path, double[] from, double[] to) {
    double bulge = from[2];
    double dx = to[0] - from[0];
    double dy = to[1] - from[1];
    double chord = Math.hypot(dx, dy);
    if (Math.abs(bulge) > STRAIGHT && chord > 0) {
      double towardsCentre = (1 - bulge * bulge) / (4 * bulge);
      double x = (from[0] + to[0]) / 2 - towardsCentre * dy;
      double y = (from[1] + to[1]) / 2 + towardsCentre * dx;
      double start = Math.toDegrees(Math.atan2(from[1] - y, from[0] - x));
      double sweep = Math.toDegrees(4 * Math.atan(bulge));
      path.append(arc(x, y, Math.hypot(from[0] - x, from[1] - y), start, sweep), true);
    }
    path.lineTo(to[0], to[1]);
  }

  /**
   * Returns an arc of an ellipse.
   *
   * @param axis the end of the major axis from the centre
   * @param ratio ratio of the minor axis to the major one
   * @param start parameter, in radians
   * @param end parameter, in radians
   */
  static Shape ellipse(double[] centre, double[] axis, double ratio, double start, double end) {
    double full = 2 * Math.PI;
    double sweep = end - start;
    sweep = sweep <= 0 ? sweep + full * Math.ceil(-sweep / full + 1e-12) : Math.min(full, sweep);
    AffineTransform transform =
        new AffineTransform(
            axis[0], axis[1], -ratio * axis[1], ratio * axis[0], centre[0], centre[1]);
    return transform.createTransformedShape(
        arc(0, 0, 1, Math.toDegrees(start), Math.toDegrees(sweep)));
  }

  /**
   * Returns chords of a rational B-spline, by de Boor's algorithm.
   *
   * @param control x, y and weight of the control points
   * @param knots not falling, one more than degree and control points together
   */
  static Shape spline(int degree, List<double[]> control, double[] knots) {
    Path2D path = new Path2D.Double();
    for (int span = degree; span < control.size(); span++) {
      for (int step = 0; step <= STEPS_PER_SPAN && knots[span] < knots[span + 1]; step++) {
        double share = (double) step / STEPS_PER_SPAN;
        double[] point =
            point(
                degree,
                control,
                knots,
                span,
                knots[span] + share * (knots[span + 1] - knots[span]));
        if (path.getCurrentPoint() == null) {
          path.moveTo(point[0], point[1]);
        } else if (step > 0) {
          path.lineTo(point[0], point[1]);
        }
      }
    }
    return path;
  }

  private static double[] point(
      int degree, List<double[]> control, double[] knots, int span, double at) {
    double[][] points = new double[degree + 1][];
    for (int i = 0; i <= degree; i++) {
      double[] corner = control.get(span - degree + i);
      points[i] = new double[] {corner[0] * corner[2], corner[1] * corner[2], corner[2]};
    }
    for (int level = 1; level <= degree; level++) {
      for (int i = degree; i >= level; i--) {
        int knot = span - degree + i;
        double share = (at - knots[knot]) / (knots[knot + degree - level + 1] - knots[knot]);
        for (int axis = 0; axis < 3; axis++) {
          points[i][axis] = (1 - share) * points[i - 1][axis] + share * points[i][axis];
        }
      }
    }
    double[] last = points[degree];
    return new double[] {last[0] / last[2], last[1] / last[2]};
  }

  /** Whether numbers describe a spline. */
  static boolean isSpline(int degree, List<double[]> control, double[] knots) {
    boolean rises = true;
    for (int i = 1; i < knots.length; i++) {
      rises &= knots[i] >= knots[i - 1];
    }
    return rises
        && degree >= 1
        && degree <= MAX_DEGREE
        && control.size() > degree
        && knots.length == control.size() + degree + 1
        && control.stream().allMatch(point -> point[2] > 0)
        && Arrays.stream(knots).allMatch(Double::isFinite);
  }
}
