package org.hificamsim.core.silhouette;

/**
 * The pieces of walls by their direction from a camera, in equal sectors of the full turn; in each
 * sector the nearest first, without those behind a wall that closes it. A sector is computed when
 * it is first needed.
 */
final class WallSectors {
  private static final int SECTORS = 256;
  private static final double WIDTH = 2 * Math.PI / SECTORS;
  private static final double MARGIN = 1e-6;

  private final Walls walls;
  private final SectorClip clip;
  private final WallSector[] sectors = new WallSector[SECTORS];

  /** The number of the last silhouette that each piece was put in front of. */
  private final long[] added;

  private long silhouettes;

  WallSectors(Walls walls, double x, double y, boolean flat) {
    this.walls = walls;
    clip = new SectorClip(walls, x, y, flat);
    added = new long[walls.count()];
  }

  boolean isFor(double x, double y, boolean flat) {
    return clip.isFor(x, y, flat);
  }

  /** Puts the walls in front of a silhouette that may hide it. */
  void addTo(Silhouette silhouette, double bearing) {
    silhouettes++;
    double half = silhouette.halfAngle() + MARGIN;
    int first = (int) Math.floor((bearing - half) / WIDTH);
    int last = Math.min((int) Math.floor((bearing + half) / WIDTH), first + SECTORS - 1);
    for (int number = first; number <= last && !silhouette.hidden(); number++) {
      add(sector(Math.floorMod(number, SECTORS)), silhouette);
    }
  }

  private WallSector sector(int number) {
    if (sectors[number] == null) {
      sectors[number] = clip.sector(number * WIDTH - MARGIN, WIDTH + 2 * MARGIN);
    }
    return sectors[number];
  }

  private void add(WallSector sector, Silhouette silhouette) {
    double limit = silhouette.farthest();
    for (int i = sector.count() - 1; i >= 0 && !silhouette.hidden(); i--) {
      int piece = sector.piece(i);
      if (sector.nearest(i) < limit && added[piece] != silhouettes) {
        added[piece] = silhouettes;
        silhouette.addWall(walls, piece);
      }
    }
  }
}
