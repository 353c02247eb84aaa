package org.hificamsim.network.statistics;

import java.util.List;
import java.util.stream.DoubleStream;
import org.hificamsim.core.visibility.Pose;
import org.hificamsim.core.world.Cameras;

/**
 * A camera's field of view: a sector of a circle, or a whole circle.
 *
 * @param x of its centre, metres
 * @param y of its centre, metres
 * @param heading middle of the opening, radians, 0 is +y and pi/2 is +x
 * @param angle full opening, radians, (0, 2 pi]
 * @param radius metres, 0 or more
 */
record FieldOfView(double x, double y, double heading, double angle, double radius) {
  private static final double ROUND = 2 * Math.PI;

  /** How far from an edge it is asked what lies to either side, as a part of both radii. */
  private static final double OFFSET = 1e-9;

  /** What a camera sees now: nothing, of radius 0, while it moves blindly. */
  static FieldOfView of(Cameras cameras, int camera) {
    int seeing = cameras.seeing(camera);
    int view = seeing == Cameras.NO_VIEW ? cameras.view(camera) : seeing;
    Pose pose = cameras.pose(camera, view);
    double angle = cameras.zoom(camera, view).viewingAngle();
    return new FieldOfView(pose.x(), pose.y(), pose.heading(), angle, cameras.range(camera));
  }

  /** Whether the point lies inside. */
  boolean contains(double px, double py) {
    double dx = px - x;
    double dy = py - y;
    double squared = dx * dx + dy * dy;
    if (squared > radius * radius) {
      return false;
    }
    if (angle >= ROUND) {
      return true;
    }
    double along = dx * Math.sin(heading) + dy * Math.cos(heading);
    return along >= Math.cos(angle / 2) * Math.sqrt(squared);
  }

  /** Its boundary, anticlockwise. */
  private List<Edge> edges() {
    double extent = Math.min(angle, ROUND);
    Edge.Arc arc = new Edge.Arc(x, y, radius, Math.PI / 2 - heading - extent / 2, extent);
    return angle >= ROUND
        ? List.of(arc)
        : List.of(
            Edge.Side.between(x, y, arc.x(0), arc.y(0)),
            arc,
            Edge.Side.between(arc.x(1), arc.y(1), x, y));
  }

  /**
   * The area that this field of view and another have in common, exact but for rounding: Green's
   * theorem along the parts of each boundary that lie inside the other.
   *
   * <p>Whether a part lies inside is tested slightly to the side of its middle, so that boundaries
   * that coincide count once where the insides are on the same side, and not at all otherwise.
   *
   * @return square metres
   */
  double overlap(FieldOfView other) {
    double reach = radius + other.radius;
    if (radius == 0 || other.radius == 0 || Math.hypot(x - other.x, y - other.y) >= reach) {
      return 0;
    }
    List<Edge> edges = edges();
    List<Edge> others = other.edges();
    double offset = OFFSET * reach;
    double area = 0;
    for (Edge edge : edges) {
      area += other.areaInside(edge, others, offset, false);
    }
    for (Edge edge : others) {
      area += areaInside(edge, edges, offset, true);
    }
    return Math.max(area, 0);
  }

  /**
   * The share of an area that belongs to the parts of another's edge inside this field of view.
   *
   * @param edges of this one
   * @param bothSides whether a part must have this field of view on either side of it
   */
  private double areaInside(Edge edge, List<Edge> edges, double offset, boolean bothSides) {
    double[] at = cuts(edge, edges);
    double area = 0;
    for (int i = 1; i < at.length; i++) {
      double middle = (at[i - 1] + at[i]) / 2;
      if (liesBy(edge, middle, offset) && (!bothSides || liesBy(edge, middle, -offset))) {
        area += edge.areaBetween(at[i - 1], at[i]);
      }
    }
    return area;
  }

  /** The parameters at which an edge is cut: 0, 1, and crossings between, rising. */
  private static double[] cuts(Edge edge, List<Edge> others) {
    DoubleStream.Builder crossings = DoubleStream.builder();
    others.forEach(other -> edge.cross(other, crossings));
    DoubleStream inside = crossings.build().filter(cut -> cut > 0 && cut < 1);
    return DoubleStream.concat(inside, DoubleStream.of(0, 1)).sorted().toArray();
  }

  private boolean liesBy(Edge edge, double t, double left) {
    return contains(edge.x(t) + left * edge.leftX(t), edge.y(t) + left * edge.leftY(t));
  }
}
