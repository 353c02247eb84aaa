package org.hificamsim.network.statistics;

import java.util.List;
import java.util.stream.DoubleStream;

/**
 * The area that two fields of view have in common, exact but for rounding: Green's theorem along
 * the parts of each boundary that lie inside the other sector.
 *
 * <p>Whether a part lies inside is tested slightly beside its middle, so that boundaries that
 * coincide count once where the insides are on the same side, and not at all otherwise.
 */
final class SectorOverlap {
  private static final double OFFSET = 1e-9;

  private SectorOverlap() {}

  /** Square metres. */
  static double of(Sector first, Sector second) {
    double reach = first.radius() + second.radius();
    if (Math.hypot(first.x() - second.x(), first.y() - second.y()) >= reach) {
      return 0;
    }
    if (first.radius() == 0 || second.radius() == 0) {
      return 0;
    }
    List<Edge> ofFirst = edges(first);
    List<Edge> ofSecond = edges(second);
    double offset = OFFSET * reach;
    double area = 0;
    for (Edge edge : ofFirst) {
      area += inside(edge, ofSecond, second, offset, false);
    }
    for (Edge edge : ofSecond) {
      area += inside(edge, ofFirst, first, offset, true);
    }
    return Math.max(area, 0);
  }

  /**
   * @param bothSides whether a part must have the sector on either side of it
   */
  private static double inside(
      Edge edge, List<Edge> others, Sector sector, double offset, boolean bothSides) {
    double[] at = cuts(edge, others);
    double area = 0;
    for (int i = 1; i < at.length; i++) {
      double middle = (at[i - 1] + at[i]) / 2;
      if (beside(edge, middle, sector, offset)
          && (!bothSides || beside(edge, middle, sector, -offset))) {
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

  private static boolean beside(Edge edge, double t, Sector sector, double left) {
    return sector.contains(edge.x(t) + left * edge.leftX(t), edge.y(t) + left * edge.leftY(t));
  }

  private static List<Edge> edges(Sector sector) {
    double start = sector.arcStart();
    double extent = Math.min(sector.angle(), 2 * Math.PI);
    Edge.Arc arc = new Edge.Arc(sector.x(), sector.y(), sector.radius(), start, extent);
    if (sector.isCircle()) {
      return List.of(arc);
    }
    return List.of(
        Edge.Side.between(sector.x(), sector.y(), arc.x(0), arc.y(0)),
        arc,
        Edge.Side.between(arc.x(1), arc.y(1), sector.x(), sector.y()));
  }
}
