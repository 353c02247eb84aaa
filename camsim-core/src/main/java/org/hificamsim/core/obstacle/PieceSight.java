package org.hificamsim.core.obstacle;

/**
 * How one piece is seen from a standpoint that it does not touch, in one of the sectors of all
 * round: what of it is between the two rays that bound the sector. Bounds hold with all rounding.
 */
final class PieceSight {
  /** Of the squared size of the scene: far more than rounding adds to a squared distance. */
  private static final double SLACK = 1e-8;

  /** A radius that is surely too large, or too small, by far more than rounding. */
  private static final double TOO_LARGE = 1 + 1e-9;

  private static final double TOO_SMALL = 1 - 1e-9;

  /** A crossing seen under a smaller angle than this is not computed. */
  private static final double GRAZING = 1e-5;

  /** Far more than what rounding does to a crossing that is computed, as a part of the edge. */
  private static final double PART = 1e-9;

  private final Pieces pieces;
  private final double atX;
  private final double atY;
  private final int sectors;

  // The rays, a little outside of the sector.
  private double rightX;
  private double rightY;
  private double leftX;
  private double leftY;

  // The part of an edge that is in the sector, from 0 to 1.
  private double start;
  private double end;

  private boolean spans;
  private double near;
  private double far;

  PieceSight(Pieces pieces, double atX, double atY, int sectors) {
    this.pieces = pieces;
    this.atX = atX;
    this.atY = atY;
    this.sectors = sectors;
  }

  /** Looks into a sector. */
  void enter(int sector) {
    double right = Sector.ROUND * sector / sectors - Sector.ROUNDING;
    double left = Sector.ROUND * (sector + 1) / sectors + Sector.ROUNDING;
    rightX = Sector.x(right);
    rightY = Sector.y(right);
    leftX = Sector.x(left);
    leftY = Sector.y(left);
  }

  /** Looks at a piece; whether any of it may be in the sector. */
  boolean meets(int piece) {
    double x = pieces.x1[piece] - atX;
    double y = pieces.y1[piece] - atY;
    return pieces.radius[piece] > 0
        ? meetsPillar(x, y, pieces.radius[piece])
        : meetsEdge(x, y, pieces.x2[piece] - atX, pieces.y2[piece] - atY);
  }

  private boolean meetsEdge(double fromX, double fromY, double toX, double toY) {
    double size = Math.abs(fromX) + Math.abs(fromY) + Math.abs(toX) + Math.abs(toY);
    start = 0;
    end = 1;
    if (!cut(leftOfRight(fromX, fromY), leftOfRight(toX, toY), size)
        || !cut(-leftOfLeft(fromX, fromY), -leftOfLeft(toX, toY), size)
        || start > end + PART) {
      return false;
    }
    spans = start > 0 && end < 1 && end - start > PART;
    double dx = toX - fromX;
    double dy = toY - fromY;
    double nearest = -(fromX * dx + fromY * dy) / (dx * dx + dy * dy);
    double foot = Math.max(start, Math.min(end, nearest));
    double slack = SLACK * size * size;
    near = square(fromX + foot * dx, fromY + foot * dy) - slack;
    far =
        slack
            + Math.max(
                square(fromX + start * dx, fromY + start * dy),
                square(fromX + end * dx, fromY + end * dy));
    return true;
  }

  /**
   * Cuts off what of an edge is on the wrong side of a ray.
   *
   * @param from how far the one end is on the right side; below 0 on the wrong one
   * @param to how far the other end is
   * @return whether anything is left
   */
  private boolean cut(double from, double to, double size) {
    if (Math.abs(from - to) > GRAZING * size) {
      double crossing = from / (from - to);
      start = from < 0 ? Math.max(start, crossing) : start;
      end = to < 0 ? Math.min(end, crossing) : end;
    }
    return from >= 0 || to >= 0;
  }

  private boolean meetsPillar(double x, double y, double radius) {
    double distance = Math.sqrt(square(x, y));
    double offRight = leftOfRight(x, y) / Math.sqrt(square(rightX, rightY));
    double offLeft = leftOfLeft(x, y) / Math.sqrt(square(leftX, leftY));
    boolean beforeRight = x * rightX + y * rightY > 0;
    boolean beforeLeft = x * leftX + y * leftY > 0;
    spans =
        beforeRight
            && beforeLeft
            && Math.max(Math.abs(offRight), Math.abs(offLeft)) < radius * TOO_SMALL;
    double slack = SLACK * square(distance + radius, 0);
    double gap = Math.max(0, distance - radius);
    near = gap * gap - slack;
    far = distance * distance - radius * radius + slack;
    return (beforeRight || beforeLeft)
        && offRight > -radius * TOO_LARGE
        && offLeft < radius * TOO_LARGE;
  }

  /** How far a point is to the left of the sector's right ray, times the length of that. */
  private double leftOfRight(double x, double y) {
    return rightX * y - rightY * x;
  }

  private double leftOfLeft(double x, double y) {
    return leftX * y - leftY * x;
  }

  private static double square(double x, double y) {
    return x * x + y * y;
  }

  /** Whether all rays of the sector meet the piece. */
  boolean spans() {
    return spans;
  }

  /** A squared distance that nothing of the piece within the sector is nearer than. */
  double near() {
    return Math.max(0, near);
  }

  /** A squared distance beyond which everything in the sector is behind a piece that spans it. */
  double far() {
    return far;
  }
}
