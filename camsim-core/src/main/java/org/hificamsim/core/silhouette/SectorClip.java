package org.hificamsim.core.silhouette;

/** Cuts walls to a sector of the directions from a camera. */
final class SectorClip {
  /**
   * A bound on rounding errors where a wall passes through the camera, as a share of the wall's
   * length.
   */
  private static final double ROUNDING = 1e-12;

  private final Walls walls;
  private final double fromX;
  private final double fromY;
  private final boolean flat;

  // directions in which the sector begins and ends

  private double beginX;
  private double beginY;
  private double endX;
  private double endY;

  /** The part of an edge that is in the sector, as shares of the way from its first end. */
  private double from;

  private double to;

  /**
   * @param flat whether all walls have the full height
   */
  SectorClip(Walls walls, double x, double y, boolean flat) {
    this.walls = walls;
    fromX = x;
    fromY = y;
    this.flat = flat;
  }

  boolean isFor(double x, double y, boolean flatWorld) {
    return x == fromX && y == fromY && flat == flatWorld;
  }

  /** Returns the walls from an angle, counter-clockwise; radians, less than half a turn. */
  WallSector sector(double angle, double width) {
    beginX = Math.cos(angle);
    beginY = Math.sin(angle);
    endX = Math.cos(angle + width);
    endY = Math.sin(angle + width);
    WallSector.Builder sector = new WallSector.Builder();
    for (int piece = 0; piece < walls.count(); piece++) {
      if (walls.radius(piece) > 0) {
        addPillar(piece, angle + width / 2, width / 2, sector);
      } else {
        addEdge(piece, sector);
      }
    }
    return sector.build();
  }

  private void addPillar(int piece, double middle, double half, WallSector.Builder sector) {
    double x = walls.x1(piece) - fromX;
    double y = walls.y1(piece) - fromY;
    double away = Math.hypot(x, y);
    double radius = walls.radius(piece);
    double off = Math.abs(Math.IEEEremainder(Math.atan2(y, x) - middle, 2 * Math.PI));
    if (away <= radius || off <= half + Math.asin(radius / away)) {
      sector.add(piece, Math.max(0, away - radius));
    }
  }

  private void addEdge(int piece, WallSector.Builder sector) {
    double x1 = walls.x1(piece) - fromX;
    double y1 = walls.y1(piece) - fromY;
    double x2 = walls.x2(piece) - fromX;
    double y2 = walls.y2(piece) - fromY;
    double left1 = beginX * y1 - beginY * x1;
    double left2 = beginX * y2 - beginY * x2;
    double right1 = x1 * endY - y1 * endX;
    double right2 = x2 * endY - y2 * endX;
    from = 0;
    to = 1;
    cut(left1, left2);
    cut(right1, right2);
    if (from <= to + ROUNDING) {
      sector.add(piece, distance(x1, y1, x2, y2, foot(x1, y1, x2, y2)));
      boolean spans = (left1 < 0 && right2 < 0) || (left2 < 0 && right1 < 0);
      if (spans && from <= to && (flat || walls.isFull(piece))) {
        sector.close(Math.max(distance(x1, y1, x2, y2, from), distance(x1, y1, x2, y2, to)));
      }
    }
  }

  /** Cuts off what is on the negative side; the sides of both ends are given. */
  private void cut(double side1, double side2) {
    if (side1 < 0) {
      from = side2 < 0 ? Double.POSITIVE_INFINITY : Math.max(from, side1 / (side1 - side2));
    } else if (side2 < 0) {
      to = Math.min(to, side1 / (side1 - side2));
    }
  }

  /** The share of the way at which the part is nearest. */
  private double foot(double x1, double y1, double x2, double y2) {
    double dx = x2 - x1;
    double dy = y2 - y1;
    double share = -(x1 * dx + y1 * dy) / (dx * dx + dy * dy);
    return share > from ? Math.min(share, Math.max(from, to)) : from;
  }

  private static double distance(double x1, double y1, double x2, double y2, double share) {
    return Math.hypot(x1 + share * (x2 - x1), y1 + share * (y2 - y1));
  }
}
