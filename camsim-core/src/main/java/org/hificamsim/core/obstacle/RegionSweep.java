package org.hificamsim.core.obstacle;

import java.util.Arrays;

/**
 * Goes round a standpoint, sector by sector, and notes what is met in each, how near it can be
 * there, and what it hides. Bounds are on the safe side of rounding: what they do not decide, the
 * exact test does.
 */
final class RegionSweep {
  private static final int MIN_SECTORS = 16;
  private static final int MAX_SECTORS = 128;

  private final Pieces pieces;
  private final PieceSight sight;
  private final boolean[] inside; // by obstacle: whether the standpoint is in it, or on its border
  private final float[] limits;
  private final int[] ends;
  private int[] met = new int[256];

  RegionSweep(Obstacles obstacles, double x, double y) {
    this.pieces = obstacles.pieces();
    int sectors = sectors(pieces.count());
    this.sight = new PieceSight(pieces, x, y, sectors);
    this.inside = new boolean[obstacles.all().size()];
    for (int i = 0; i < inside.length; i++) {
      inside[i] = obstacles.all().get(i).contains(x, y);
    }
    this.limits = new float[sectors * VisibleRegion.LIMITS];
    this.ends = new int[sectors + 1];
    float[] nears = new float[pieces.count()];
    for (int sector = 0; sector < sectors; sector++) {
      ends[sector + 1] = sweep(sector, ends[sector], nears);
    }
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
    return Arrays.copyOf(met, ends[ends.length - 1]);
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

  /** Notes what is met in a sector; returns where the notes end. */
  private int sweep(int sector, int first, float[] nears) {
    met = met.length < first + nears.length ? Arrays.copyOf(met, 2 * (first + nears.length)) : met;
    float touched = Float.POSITIVE_INFINITY;
    float hidden = Float.POSITIVE_INFINITY;
    int end = first;
    sight.enter(sector);
    for (int piece = 0; piece < nears.length; piece++) {
      int obstacle = pieces.obstacle[piece];
      boolean at = inside[obstacle];
      if (at ? piece == pieces.first[obstacle] : sight.meets(piece)) {
        float near = at ? -1 : Math.nextDown((float) sight.near());
        nears[end - first] = near;
        met[end++] = at ? ~piece : piece;
        touched = Math.min(touched, near);
        if (pieces.hides(piece) && (at || sight.spans())) {
          hidden = Math.min(hidden, at ? -1 : Math.nextUp((float) sight.far()));
        }
      }
    }
    limits[VisibleRegion.LIMITS * sector + VisibleRegion.TOUCHED] = touched;
    limits[VisibleRegion.LIMITS * sector + VisibleRegion.HIDDEN] = hidden;
    return withoutHidden(first, end, nears, hidden);
  }

  private int withoutHidden(int first, int end, float[] nears, float hidden) {
    int kept = first;
    for (int i = first; i < end; i++) {
      met[kept] = met[i];
      kept += nears[i - first] > hidden ? 0 : 1;
    }
    return kept;
  }
}
