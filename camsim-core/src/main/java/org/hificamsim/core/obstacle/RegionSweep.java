package org.hificamsim.core.obstacle;

import java.util.Arrays;

/**
 * Goes round a standpoint, piece by piece, and notes for each sector that a piece is met in how
 * near it can be there, and whether it hides what is behind. Bounds are on the safe side of
 * rounding: what they do not decide, the exact test does.
 */
final class RegionSweep {
  private static final int MIN_SECTORS = 16;
  private static final int MAX_SECTORS = 128;

  private final Obstacles obstacles;
  private final Pieces pieces;
  private final PieceSight sight;
  private final int sectors;
  private final float[] limits;
  private final int[] ends;
  private final int[] met;

  // What was noted, piece by piece.
  private int notes;
  private int[] noteSector = new int[256];
  private int[] notePiece = new int[256];
  private float[] noteNear = new float[256];

  RegionSweep(Obstacles obstacles, double x, double y) {
    this.obstacles = obstacles;
    this.pieces = obstacles.pieces();
    this.sight = new PieceSight(pieces, x, y);
    this.sectors = sectors(pieces.count());
    this.limits = new float[sectors * VisibleRegion.LIMITS];
    this.ends = new int[sectors + 1];
    Arrays.fill(limits, Float.POSITIVE_INFINITY);
    noteAll(x, y);
    this.met = sorted();
  }

  float[] limits() {
    return limits;
  }

  /** By sector: where what is met in it begins; one more is the end of the last. */
  int[] ends() {
    return ends;
  }

  /** What is met, sector by sector, in each in the order of obstacles. */
  int[] met() {
    return met;
  }

  /** The piece that an entry means. */
  static int piece(int met) {
    return met < 0 ? ~met : met;
  }

  /** Whether an entry means an obstacle that the standpoint is inside or on the border of. */
  static boolean atStandpoint(int met) {
    return met < 0;
  }

  private static int sectors(int pieces) {
    int wanted = Integer.highestOneBit(Math.max(1, pieces)) * 8;
    return pieces == 0 ? 1 : Math.max(MIN_SECTORS, Math.min(MAX_SECTORS, wanted));
  }

  private void noteAll(double x, double y) {
    for (int i = 0; i + 1 < pieces.first.length; i++) {
      if (obstacles.all().get(i).contains(x, y)) {
        noteStandpoint(i);
      } else {
        for (int piece = pieces.first[i]; piece < pieces.first[i + 1]; piece++) {
          see(piece);
        }
      }
    }
  }

  private void noteStandpoint(int obstacle) {
    int piece = pieces.first[obstacle];
    for (int sector = 0; sector < sectors; sector++) {
      note(sector, ~piece, -1);
      if (pieces.hides(piece)) {
        lower(sector, VisibleRegion.HIDDEN, -1);
      }
    }
  }

  private void see(int piece) {
    sight.look(piece, sectors);
    boolean hides = pieces.hides(piece);
    for (int i = sight.firstSector(); i <= sight.lastSector(); i++) {
      sight.enter(i);
      int sector = i & sectors - 1;
      note(sector, piece, Math.nextDown((float) sight.near()));
      if (hides && sight.spans()) {
        lower(sector, VisibleRegion.HIDDEN, Math.nextUp((float) sight.far()));
      }
    }
  }

  private void note(int sector, int piece, float near) {
    if (notes == noteSector.length) {
      noteSector = Arrays.copyOf(noteSector, 2 * notes);
      notePiece = Arrays.copyOf(notePiece, 2 * notes);
      noteNear = Arrays.copyOf(noteNear, 2 * notes);
    }
    noteSector[notes] = sector;
    notePiece[notes] = piece;
    noteNear[notes++] = near;
    lower(sector, VisibleRegion.TOUCHED, near);
  }

  private void lower(int sector, int limit, float value) {
    int at = VisibleRegion.LIMITS * sector + limit;
    limits[at] = Math.min(limits[at], value);
  }

  /** What is not hidden, by sector: a counting sort, which keeps the order within a sector. */
  private int[] sorted() {
    int kept = 0;
    for (int i = 0; i < notes; i++) {
      if (!hidden(i)) {
        ends[noteSector[i]]++;
        kept++;
      }
    }
    int start = 0;
    for (int i = 0; i <= sectors; i++) {
      int count = ends[i];
      ends[i] = start;
      start += count;
    }
    int[] sorted = new int[kept];
    for (int i = 0; i < notes; i++) {
      if (!hidden(i)) {
        sorted[ends[noteSector[i]]++] = notePiece[i];
      }
    }
    System.arraycopy(ends, 0, ends, 1, sectors);
    ends[0] = 0;
    return sorted;
  }

  private boolean hidden(int note) {
    return noteNear[note] > limits[VisibleRegion.LIMITS * noteSector[note] + VisibleRegion.HIDDEN];
  }
}
