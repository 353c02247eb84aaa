package org.hificamsim.core.obstacle;

import java.util.Arrays;

/**
 * The region that is visible from a standpoint past obstacles that do not move. It gives exactly
 * the answers of {@link Obstacles}, by a look-up by direction that is computed once by a sweep
 * around the standpoint. Queries allocate nothing, except for points so close to a border that
 * doubles cannot decide. Safe for use by several threads.
 *
 * <p>The directions are divided into equal sectors ({@link Sector}). For each sector the sweep
 * finds the distance below which nothing is touched, the distance beyond which a solid obstacle
 * that spans the sector hides everything, and the pieces in between: only points between these
 * distances are tested against pieces. The distances allow for rounding.
 */
public final class VisibleRegion {
  private static final int MIN_SECTORS = 16;
  private static final int MAX_SECTORS = 128;

  private final double fromX;
  private final double fromY;
  private final Pieces pieces;
  private final Obstacles obstacles;
  private final int sectors;

  /** The squared distance below which nothing is touched, by sector. */
  final float[] clearWithin;

  /** The squared distance above which everything is hidden, by sector. */
  final float[] hiddenBeyond;

  /** The index of each sector's first entry in {@link #met}; the last entry is the end. */
  private final int[] starts;

  /**
   * The pieces met in each sector, in the order of obstacles. An obstacle that contains the
   * standpoint is represented by the complement {@code ~} of its first piece.
   */
  int[] met = new int[256];

  private VisibleRegion(Obstacles obstacles, double x, double y) {
    this.obstacles = obstacles;
    this.pieces = obstacles.pieces();
    this.fromX = x;
    this.fromY = y;
    int wanted = Integer.highestOneBit(Math.max(1, pieces.count())) * 8;
    sectors = pieces.count() == 0 ? 1 : Math.max(MIN_SECTORS, Math.min(MAX_SECTORS, wanted));
    clearWithin = new float[sectors];
    hiddenBeyond = new float[sectors];
    starts = new int[sectors + 1];
    sweep();
  }

  /** Computes the region visible from a point. */
  public static VisibleRegion of(Obstacles obstacles, double x, double y) {
    return new VisibleRegion(obstacles, x, y);
  }

  private void sweep() {
    boolean[] inside = new boolean[obstacles.all().size()];
    for (int i = 0; i < inside.length; i++) {
      inside[i] = obstacles.all().get(i).contains(fromX, fromY);
    }
    PieceSight sight = new PieceSight(pieces, fromX, fromY, sectors);
    float[] nears = new float[pieces.count()];
    for (int sector = 0; sector < sectors; sector++) {
      sweep(sector, sight, inside, nears);
    }
    met = Arrays.copyOf(met, starts[sectors]);
  }

  /** Finds the pieces met in a sector, without those that are hidden. */
  private void sweep(int sector, PieceSight sight, boolean[] inside, float[] nears) {
    int first = starts[sector];
    met = met.length < first + nears.length ? Arrays.copyOf(met, 2 * (first + nears.length)) : met;
    clearWithin[sector] = Float.POSITIVE_INFINITY;
    hiddenBeyond[sector] = Float.POSITIVE_INFINITY;
    int end = first;
    sight.enter(sector);
    for (int piece = 0; piece < nears.length; piece++) {
      int obstacle = pieces.obstacle[piece];
      boolean contains = inside[obstacle];
      if (contains ? piece == pieces.first[obstacle] : sight.meets(piece)) {
        float near = contains ? -1 : Math.nextDown((float) sight.near());
        nears[end - first] = near;
        met[end++] = contains ? ~piece : piece;
        clearWithin[sector] = Math.min(clearWithin[sector], near);
        if (pieces.hides(piece) && (contains || sight.spans())) {
          float far = contains ? -1 : Math.nextUp((float) sight.far());
          hiddenBeyond[sector] = Math.min(hiddenBeyond[sector], far);
        }
      }
    }
    int kept = first;
    for (int i = first; i < end; i++) {
      met[kept] = met[i];
      kept += nears[i - first] > hiddenBeyond[sector] ? 0 : 1;
    }
    starts[sector + 1] = kept;
  }

  /** Whether the standpoint is this point. */
  public boolean isFrom(double x, double y) {
    return fromX == x && fromY == y;
  }

  /** The {@link Obstacles#transmittance} from the standpoint to a point. */
  public double transmittance(double x, double y) {
    return transmittance(x, y, Double.NaN, 0, 0);
  }

  /**
   * The transmittance in space from the standpoint, see {@link Obstacles#transmittance(double,
   * double, double, double, double, double, double)}.
   *
   * @param z the height of the standpoint, in metres; NaN in a flat world
   * @param low the lowest height of the upright line, in metres
   * @param high the greatest height of the upright line, in metres
   */
  public double transmittance(double x, double y, double z, double low, double high) {
    double dx = x - fromX;
    double dy = y - fromY;
    int sector = (int) (Sector.measure(dx, dy) * (sectors / Sector.ROUND)) & sectors - 1;
    double square = dx * dx + dy * dy;
    if (square < clearWithin[sector]) {
      return 1;
    }
    return square > hiddenBeyond[sector] ? 0 : product(sector, x, y, z, low, high);
  }

  /** Tests obstacles of finite height as a whole, since a line may descend inside of them. */
  private double product(int sector, double x, double y, double z, double low, double high) {
    double product = 1;
    int tested = -1;
    for (int i = starts[sector]; i < starts[sector + 1] && product > 0; i++) {
      int obstacle = pieces.obstacle[met[i] < 0 ? ~met[i] : met[i]];
      if (obstacle != tested) {
        boolean full = pieces.full[obstacle];
        boolean touches =
            full
                ? met[i] < 0 || pieces.touches(met[i], fromX, fromY, x, y)
                : obstacles.all().get(obstacle).touches(fromX, fromY, z, x, y, low, high);
        product *= touches ? pieces.transmittance[obstacle] : 1;
        tested = touches || !full ? obstacle : tested;
      }
    }
    return product;
  }
}
