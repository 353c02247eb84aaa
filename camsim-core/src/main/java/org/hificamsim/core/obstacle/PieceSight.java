package org.hificamsim.core.obstacle;

/**
 * One piece as it is seen within a sector, from a standpoint that it does not touch: the part of
 * the piece between the two rays that bound the sector. All bounds allow for rounding.
 */
final class PieceSight {
  /**
   * A bound far above the error of a squared distance, relative to the squared size of the scene.
   */
  private static final double SLACK = 1e-8;

  /** Factors that make a radius certainly too large or too small, in spite of rounding. */
  private static final double TOO_LARGE = 1 + 1e-9;

  private static final double TOO_SMALL = 1 - 1e-9;

  /** The least angle at which crossings are computed. */
  private static final double GRAZING = 1e-5;

  /** A bound far above the rounding error of a computed crossing, as a part of the edge. */
  private static final double CROSSING_ERROR = 1e-9;

  private final Pieces pieces;
  private final double standX;
  private final double standY;
  private final int sectors;

  // The directions of the two rays, slightly outside the sector.
  private double rightX;
  private double rightY;
  private double leftX;
  private double leftY;

  // The part of an edge that is in the sector, in [0, 1].
  private double start;
  private double end;

  private boolean spans;
  private double near;
  private double far;

  PieceSight(Pieces pieces, double standX, double standY, int sectors) {
    this.pieces = pieces;
    this.standX = standX;
    this.standY = standY;
    this.sectors = sectors;
  }

  /** Selects a sector. */
  void enter(int sector) {
    double right = Sector.ROUND * sector / sectors - Sector.ROUNDING;
    double left = Sector.ROUND * (sector + 1) / sectors + Sector.ROUNDING;
    rightX = Sector.x(right);
    rightY = Sector.y(right);
    leftX = Sector.x(left);
    leftY = Sector.y(left);
  }

  /** Selects a piece; returns whether any of it may be in the sector. */
  boolean meets(int piece) {
    double x = pieces.x1[piece] - standX;
    double y = pieces.y1[piece] - standY;
    return pieces.radius[piece] > 0
        ? meetsPillar(x, y, pieces.radius[piece])
        : meetsEdge(x, y, pieces.x2[piece] - standX, pieces.y2[piece] - standY);
  }

  private boolean meetsEdge(double fromX, double fromY, double toX, double toY) {
    double size = Math.abs(fromX) + Math.abs(fromY) + Math.abs(toX) + Math.abs(toY);
    start = 0;
    end = 1;
    if (!cut(leftOfRight(fromX, fromY), leftOfRight(toX, toY), size)
        || !cut(-leftOfLeft(fromX, fromY), -leftOfLeft(toX, toY), size)
        || start > end + CROSSING_ERROR) {
      return false;
    }
    spans = start > 0 && end < 1 && end - start > CROSSING_ERROR;
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
   * Cuts off the part of an edge that is outside a ray.
   *
   * @param from the distance of one end inside the ray; below 0 outside
   * @param to the distance of the other end inside the ray
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

  /** The distance of a point to the left of the right ray, times the length of the ray's vector. */
  private double leftOfRight(double x, double y) {
    return rightX * y - rightY * x;
  }

  /** The distance of a point to the left of the left ray, times the length of the ray's vector. */
  private double leftOfLeft(double x, double y) {
    return leftX * y - leftY * x;
  }

  private static double square(double x, double y) {
    return x * x + y * y;
  }

  /** Whether the piece meets all rays of the sector. */
  boolean spans() {
    return spans;
  }

  /** A squared distance that no point of the piece within the sector is below. */
  double near() {
    return Math.max(0, near);
  }

  /** A squared distance beyond which a piece that spans the sector hides everything. */
  double far() {
    return far;
  }
}
