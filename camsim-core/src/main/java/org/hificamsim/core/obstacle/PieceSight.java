package org.hificamsim.core.obstacle;

/**
 * How one piece is seen from a standpoint that it does not touch: in which sectors, and within
 * which squared distances in each. Bounds hold with all rounding.
 */
final class PieceSight {
  /** Of the squared size of the scene: far more than rounding adds to a squared distance. */
  private static final double SLACK = 1e-8;

  /** A radius that is surely too large, or too small, by far more than rounding. */
  private static final double TOO_LARGE = 1 + 1e-9;

  private static final double TOO_SMALL = 1 - 1e-9;

  /** A crossing seen under a smaller angle than this is not computed. */
  private static final double GRAZING = 1e-5;

  private final Pieces pieces;
  private final double atX;
  private final double atY;

  // Of the piece looked at: its ends as seen from the standpoint, counterclockwise.
  private boolean pillar;
  private double fromX;
  private double fromY;
  private double toX;
  private double toY;
  private double slack;
  private double pillarNear;
  private double pillarFar;
  private boolean allRound;
  private int sectors;
  private int firstSector;
  private int lastSector;
  private int firstSpanned;
  private int lastSpanned;

  // In the sector entered.
  private boolean spans;
  private double near;
  private double far;

  PieceSight(Pieces pieces, double atX, double atY) {
    this.pieces = pieces;
    this.atX = atX;
    this.atY = atY;
  }

  private void place(int piece) {
    double radius = pieces.radius[piece];
    pillar = radius > 0;
    fromX = pieces.x1[piece] - atX;
    fromY = pieces.y1[piece] - atY;
    if (pillar) {
      placePillar(radius);
      return;
    }
    toX = pieces.x2[piece] - atX;
    toY = pieces.y2[piece] - atY;
    double size = Math.abs(fromX) + Math.abs(fromY) + Math.abs(toX) + Math.abs(toY);
    slack = SLACK * size * size;
  }

  private void placePillar(double radius) {
    double distance = Math.sqrt(fromX * fromX + fromY * fromY);
    slack = SLACK * (distance + radius) * (distance + radius);
    double gap = Math.max(0, distance - radius);
    pillarNear = gap * gap - slack;
    pillarFar = distance * distance - radius * radius + slack;
  }

  /** Looks at a piece that does not touch the standpoint. */
  void look(int piece, int sectors) {
    this.sectors = sectors;
    place(piece);
    allRound = false;
    if (pillar) {
      lookAtPillar(pieces.radius[piece]);
    } else {
      lookAtEdge();
    }
    if (allRound) {
      firstSector = 0;
      lastSector = sectors - 1;
      firstSpanned = sectors;
    }
  }

  private void lookAtEdge() {
    double from = Sector.measure(fromX, fromY);
    double turn = Sector.turn(from, Sector.measure(toX, toY));
    if (turn < 0) {
      swap();
      from += turn;
      turn = -turn;
    }
    cover(from, turn);
    span(from, turn);
  }

  private void swap() {
    double x = fromX;
    double y = fromY;
    fromX = toX;
    fromY = toY;
    toX = x;
    toY = y;
  }

  private void lookAtPillar(double radius) {
    double outer = tangent(radius * TOO_LARGE);
    cover(rightOf(outer, radius * TOO_LARGE), turnOf(outer, radius * TOO_LARGE));
    double inner = tangent(radius * TOO_SMALL);
    span(rightOf(inner, radius * TOO_SMALL), turnOf(inner, radius * TOO_SMALL));
  }

  /** The length of a tangent from the standpoint; NaN where that is within the radius. */
  private double tangent(double radius) {
    return Math.sqrt(fromX * fromX + fromY * fromY - radius * radius);
  }

  private double rightOf(double tangent, double radius) {
    return Sector.measure(fromX * tangent + fromY * radius, fromY * tangent - fromX * radius);
  }

  private double turnOf(double tangent, double radius) {
    double left =
        Sector.measure(fromX * tangent - fromY * radius, fromY * tangent + fromX * radius);
    return Sector.turn(rightOf(tangent, radius), left);
  }

  /** Notes the sectors in which anything of the piece may be seen. */
  private void cover(double from, double turn) {
    allRound = !(turn >= 0 && turn < 2 - GRAZING);
    firstSector = floor(from - Sector.ROUNDING);
    lastSector = Math.min(floor(from + turn + Sector.ROUNDING), firstSector + sectors - 1);
  }

  /** Notes the sectors all of whose rays meet the piece. */
  private void span(double from, double turn) {
    firstSpanned = -(int) Math.floor(-(from + Sector.ROUNDING) * sectors / Sector.ROUND);
    lastSpanned = floor(from + turn - Sector.ROUNDING) - 1;
  }

  private int floor(double measure) {
    return (int) Math.floor(measure * sectors / Sector.ROUND);
  }

  int firstSector() {
    return firstSector;
  }

  /** May be the number of sectors or more: counted on from the first. */
  int lastSector() {
    return lastSector;
  }

  /** Looks at the piece within one sector. */
  void enter(int sector) {
    spans = !allRound && sector >= firstSpanned && sector <= lastSpanned;
    if (pillar) {
      near = pillarNear;
      far = pillarFar;
    } else {
      enterEdge(sector);
    }
    near = near > 0 ? near : 0;
  }

  private void enterEdge(int sector) {
    double start = sector > firstSector && !allRound ? crossing(sector) : 0;
    double end = sector < lastSector && !allRound ? crossing(sector + 1) : 1;
    spans &= start >= 0 && end >= 0;
    start = start >= 0 ? start : 0;
    end = end >= 0 ? end : 1;
    near = square(foot(start, end)) - slack;
    far = Math.max(square(start), square(end)) + slack;
  }

  /** Where on the edge, from 0 to 1, the ray that begins a sector meets it; NaN if unsure. */
  private double crossing(int sector) {
    double measure = (sector & sectors - 1) * Sector.ROUND / sectors;
    double x = Sector.x(measure);
    double y = Sector.y(measure);
    double from = x * fromY - y * fromX;
    double to = x * toY - y * toX;
    double size = Math.abs(fromX) + Math.abs(fromY) + Math.abs(toX) + Math.abs(toY);
    boolean sure = from < 0 && to > 0 && to - from > GRAZING * size;
    return sure ? from / (from - to) : Double.NaN;
  }

  /** Where on the edge, within a part of it, the point nearest to the standpoint is. */
  private double foot(double start, double end) {
    double dx = toX - fromX;
    double dy = toY - fromY;
    double along = -(fromX * dx + fromY * dy) / (dx * dx + dy * dy);
    return along > start ? Math.min(along, end) : start;
  }

  private double square(double along) {
    double x = fromX + along * (toX - fromX);
    double y = fromY + along * (toY - fromY);
    return x * x + y * y;
  }

  boolean spans() {
    return spans;
  }

  /** A squared distance that nothing of the piece within the sector is nearer than. */
  double near() {
    return near;
  }

  /** A squared distance beyond which everything in the sector is behind a piece that spans it. */
  double far() {
    return far;
  }
}
