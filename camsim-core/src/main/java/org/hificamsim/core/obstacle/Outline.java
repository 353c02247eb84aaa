package org.hificamsim.core.obstacle;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.DoubleStream;

/**
 * The border of a visible region, for drawing: rays to all ends of edges and just past them, to
 * where edges cross each other, a pillar or the reach, and all round, each cut where it first meets
 * something solid.
 */
final class Outline {
  private static final int RAYS = 256;
  private static final int RAYS_TO_A_PILLAR = 48;

  /** How far past an end a ray goes, as a measure of angle. */
  private static final double PAST = 1e-9;

  private final VisibleRegion region;
  private final Pieces pieces;
  private final double atX;
  private final double atY;
  private final int[] ends;
  private final int[] met;
  private final double reach;
  private final DoubleStream.Builder directions = DoubleStream.builder();

  Outline(VisibleRegion region, double reach) {
    this.region = region;
    this.pieces = region.pieces;
    this.atX = region.atX;
    this.atY = region.atY;
    this.ends = region.ends;
    this.met = region.met;
    this.reach = reach;
  }

  /** Counterclockwise. */
  List<Point> points() {
    for (int i = 0; i < RAYS; i++) {
      directions.add(i * Sector.ROUND / RAYS);
    }
    for (int sector = 0; sector + 1 < ends.length; sector++) {
      aimAt(sector);
    }
    List<Point> points = new ArrayList<>();
    directions.build().sorted().distinct().forEach(measure -> add(points, end(measure)));
    return List.copyOf(points);
  }

  /** Adds a corner; of three in a line, the middle one goes. */
  private static void add(List<Point> points, Point point) {
    int last = points.size() - 1;
    if (last > 0 && straight(points.get(last - 1), points.get(last), point)) {
      points.remove(last);
    }
    points.add(point);
  }

  private static boolean straight(Point a, Point b, Point c) {
    double dx = c.x() - a.x();
    double dy = c.y() - a.y();
    double offset = dx * (b.y() - a.y()) - dy * (b.x() - a.x());
    double along = dx * (b.x() - a.x()) + dy * (b.y() - a.y());
    double square = dx * dx + dy * dy;
    return Math.abs(offset) <= 1e-9 * square && along >= 0 && along <= square;
  }

  private void aimAt(int sector) {
    for (int i = ends[sector]; i < ends[sector + 1]; i++) {
      if (blocks(met[i])) {
        aimAtPiece(met[i]);
        for (int j = i + 1; j < ends[sector + 1]; j++) {
          if (blocks(met[j])) {
            aimAtCrossing(met[i], met[j]);
          }
        }
      }
    }
  }

  /** Leaves out what dims, also where the standpoint is in it. */
  private boolean blocks(int met) {
    return !RegionSweep.atStandpoint(met) && pieces.hides(met);
  }

  private void aimAtPiece(int piece) {
    double x = pieces.x1[piece];
    double y = pieces.y1[piece];
    if (pieces.radius[piece] > 0) {
      aimAtPillar(x, y, pieces.radius[piece]);
    } else {
      aimAtEnd(x, y);
      aimAtEnd(pieces.x2[piece], pieces.y2[piece]);
      aimAtCircle(piece, atX, atY, reach);
    }
  }

  private void aimAtPillar(double x, double y, double radius) {
    double dx = x - atX;
    double dy = y - atY;
    double tangent = Math.sqrt(Math.max(0, dx * dx + dy * dy - radius * radius));
    aimAtEnd(atX + dx * tangent - dy * radius, atY + dy * tangent + dx * radius);
    aimAtEnd(atX + dx * tangent + dy * radius, atY + dy * tangent - dx * radius);
    for (int i = 0; i < RAYS_TO_A_PILLAR; i++) {
      double angle = 2 * Math.PI * i / RAYS_TO_A_PILLAR;
      aim(x + radius * Math.cos(angle), y + radius * Math.sin(angle));
    }
  }

  private void aimAtEnd(double x, double y) {
    double measure = Sector.measure(x - atX, y - atY);
    directions.add(measure);
    directions.add((measure + PAST) % Sector.ROUND);
    directions.add((measure - PAST + Sector.ROUND) % Sector.ROUND);
  }

  private void aim(double x, double y) {
    directions.add(Sector.measure(x - atX, y - atY) % Sector.ROUND);
  }

  private void aimAtCrossing(int piece, int other) {
    if (pieces.radius[piece] > 0) {
      if (pieces.radius[other] == 0) {
        aimAtCrossing(other, piece);
      }
    } else if (pieces.radius[other] > 0) {
      aimAtCircle(piece, pieces.x1[other], pieces.y1[other], pieces.radius[other]);
    } else {
      aimAtCrossingEdges(piece, other);
    }
  }

  private void aimAtCrossingEdges(int piece, int other) {
    double dx = dx(piece);
    double dy = dy(piece);
    double x = pieces.x1[other] - pieces.x1[piece];
    double y = pieces.y1[other] - pieces.y1[piece];
    double along = (x * dy(other) - y * dx(other)) / (dx * dy(other) - dy * dx(other));
    if (along >= 0 && along <= 1) {
      aim(pieces.x1[piece] + along * dx, pieces.y1[piece] + along * dy);
    }
  }

  /** Where an edge crosses a circle, if it does. */
  private void aimAtCircle(int edge, double x, double y, double radius) {
    double dx = dx(edge);
    double dy = dy(edge);
    double fx = pieces.x1[edge] - x;
    double fy = pieces.y1[edge] - y;
    double square = dx * dx + dy * dy;
    double half = fx * dx + fy * dy;
    double root = Math.sqrt(half * half - square * (fx * fx + fy * fy - radius * radius));
    for (double along : new double[] {(-half - root) / square, (-half + root) / square}) {
      if (along >= 0 && along <= 1) {
        aim(pieces.x1[edge] + along * dx, pieces.y1[edge] + along * dy);
      }
    }
  }

  private double dx(int edge) {
    return pieces.x2[edge] - pieces.x1[edge];
  }

  private double dy(int edge) {
    return pieces.y2[edge] - pieces.y1[edge];
  }

  /** Where the ray in a direction ends. */
  private Point end(double measure) {
    double x = Sector.x(measure);
    double y = Sector.y(measure);
    double length = Math.hypot(x, y);
    double free = free(region.sector(x, y), x / length, y / length);
    return new Point(atX + free * x / length, atY + free * y / length);
  }

  /** How far a ray goes in a sector. */
  private double free(int sector, double x, double y) {
    double free = reach;
    for (int i = ends[sector]; i < ends[sector + 1]; i++) {
      if (blocks(met[i])) {
        double distance = pieces.radius[met[i]] > 0 ? toPillar(met[i], x, y) : toEdge(met[i], x, y);
        free = distance < free ? distance : free;
      }
    }
    return free;
  }

  /** The distance at which a ray enters a pillar; NaN where it does not. */
  private double toPillar(int pillar, double x, double y) {
    double dx = pieces.x1[pillar] - atX;
    double dy = pieces.y1[pillar] - atY;
    double offset = x * dy - y * dx;
    double radius = pieces.radius[pillar];
    double along = x * dx + y * dy;
    return along > 0 ? along - Math.sqrt(radius * radius - offset * offset) : Double.NaN;
  }

  /** The distance at which a ray meets an edge; NaN where it does not, or runs along it. */
  private double toEdge(int edge, double x, double y) {
    double cross = y * dx(edge) - x * dy(edge);
    if (side(edge) * cross >= 0) {
      return Double.NaN;
    }
    double fx = pieces.x1[edge] - atX;
    double fy = pieces.y1[edge] - atY;
    double along = (x * fy - y * fx) / cross;
    double distance = x * (fx + along * dx(edge)) + y * (fy + along * dy(edge));
    return along >= 0 && along <= 1 ? Math.max(0, distance) : Double.NaN;
  }

  /** The side of an edge that the standpoint is on; exactly, since cameras are put on walls. */
  private int side(int edge) {
    return Orientation.of(
        pieces.x1[edge], pieces.y1[edge], pieces.x2[edge], pieces.y2[edge], atX, atY);
  }
}
