package org.hificamsim.core.silhouette;

import java.util.Arrays;
import java.util.stream.IntStream;

/** The pieces of walls by their direction from a camera, in equal sectors of the full turn. */
final class WallSectors {
  private static final int SECTORS = 64;
  private static final double WIDTH = 2 * Math.PI / SECTORS;
  private static final double MARGIN = 1e-6;

  private final double fromX;
  private final double fromY;
  private final int[][] pieces;

  WallSectors(Walls walls, double x, double y) {
    fromX = x;
    fromY = y;
    pieces = new int[SECTORS][];
    Arrays.setAll(
        pieces,
        sector ->
            IntStream.range(0, walls.count())
                .filter(piece -> isIn(sector, walls, piece))
                .toArray());
  }

  boolean isFrom(double x, double y) {
    return x == fromX && y == fromY;
  }

  private boolean isIn(int sector, Walls walls, int piece) {
    double first = Math.atan2(walls.y1(piece) - fromY, walls.x1(piece) - fromX);
    double turn =
        Math.IEEEremainder(
            Math.atan2(walls.y2(piece) - fromY, walls.x2(piece) - fromX) - first, 2 * Math.PI);
    double away = Math.hypot(walls.x1(piece) - fromX, walls.y1(piece) - fromY);
    double radius = walls.radius(piece);
    double halfAngle = radius > 0 ? Math.asin(Math.min(1, radius / away)) : Math.abs(turn) / 2;
    boolean isAround = away <= radius || Math.abs(turn) > Math.PI - MARGIN;
    double middle = first + turn / 2;
    double off = Math.abs(Math.IEEEremainder(middle - (sector + 0.5) * WIDTH, 2 * Math.PI));
    return isAround || off <= halfAngle + WIDTH / 2 + MARGIN;
  }

  /** Puts the walls in front of a silhouette that may hide it; some may be put there twice. */
  void addTo(Silhouette silhouette, Walls walls, double bearing) {
    double half = silhouette.halfAngle() + MARGIN;
    int first = (int) Math.floor((bearing - half) / WIDTH);
    int last = Math.min((int) Math.floor((bearing + half) / WIDTH), first + SECTORS - 1);
    for (int sector = first; sector <= last; sector++) {
      for (int piece : pieces[Math.floorMod(sector, SECTORS)]) {
        silhouette.addWall(walls, piece);
      }
    }
  }
}
