package org.hificamsim.core.obstacle;

import java.util.Arrays;

/**
 * What can be seen from one standpoint past obstacles that do not move: the same answers as {@link
 * Obstacles} gives, to the bit, from a look-up by direction. Made once for a standpoint, by a sweep
 * all round it; asking allocates nothing, but for points so near to a border that doubles do not
 * tell. Any number of threads may ask.
 *
 * <p>All round is cut into equal sectors ({@link Sector}). A sector knows from the sweep up to
 * which distance nothing is met in it, from which distance on everything is hidden by something
 * solid that spans it, and what lies between: only for points between is that asked, exactly. The
 * bounds are on the safe side of rounding.
 */
public final class VisibleRegion {
  private static final int MIN_SECTORS = 16;
  private static final int MAX_SECTORS = 128;

  private final double atX;
  private final double atY;
  private final Pieces pieces;
  private final Obstacles obstacles;
  private final int sectors;

  /** By sector: the squared distance below which nothing is touched. */
  final float[] touched;

  /** By sector: the squared distance above which everything is hidden. */
  final float[] hidden;

  /** By sector: where what is met in it begins; one more is the end of the last. */
  private final int[] ends;

  /**
   * The pieces that are met, sector by sector, in each in the order of obstacles; of an obstacle
   * that the standpoint is inside or on the border of, {@code ~} its first one.
   */
  int[] met = new int[256];

  private VisibleRegion(Obstacles obstacles, double x, double y) {
    this.obstacles = obstacles;
    this.pieces = obstacles.pieces();
    this.atX = x;
    this.atY = y;
    int wanted = Integer.highestOneBit(Math.max(1, pieces.count())) * 8;
    sectors = pieces.count() == 0 ? 1 : Math.max(MIN_SECTORS, Math.min(MAX_SECTORS, wanted));
    touched = new float[sectors];
    hidden = new float[sectors];
    ends = new int[sectors + 1];
    sweep();
  }

  /** The region seen from a point. */
  public static VisibleRegion of(Obstacles obstacles, double x, double y) {
    return new VisibleRegion(obstacles, x, y);
  }

  private void sweep() {
    boolean[] inside = new boolean[obstacles.all().size()];
    for (int i = 0; i < inside.length; i++) {
      inside[i] = obstacles.all().get(i).contains(atX, atY);
    }
    PieceSight sight = new PieceSight(pieces, atX, atY, sectors);
    float[] nears = new float[pieces.count()];
    for (int sector = 0; sector < sectors; sector++) {
      sweep(sector, sight, inside, nears);
    }
    met = Arrays.copyOf(met, ends[sectors]);
  }

  /** Notes what is met in a sector, but for what is hidden. */
  private void sweep(int sector, PieceSight sight, boolean[] inside, float[] nears) {
    int first = ends[sector];
    met = met.length < first + nears.length ? Arrays.copyOf(met, 2 * (first + nears.length)) : met;
    touched[sector] = Float.POSITIVE_INFINITY;
    hidden[sector] = Float.POSITIVE_INFINITY;
    int end = first;
    sight.enter(sector);
    for (int piece = 0; piece < nears.length; piece++) {
      int obstacle = pieces.obstacle[piece];
      boolean at = inside[obstacle];
      if (at ? piece == pieces.first[obstacle] : sight.meets(piece)) {
        float near = at ? -1 : Math.nextDown((float) sight.near());
        nears[end - first] = near;
        met[end++] = at ? ~piece : piece;
        touched[sector] = Math.min(touched[sector], near);
        if (pieces.hides(piece) && (at || sight.spans())) {
          float far = at ? -1 : Math.nextUp((float) sight.far());
          hidden[sector] = Math.min(hidden[sector], far);
        }
      }
    }
    int kept = first;
    for (int i = first; i < end; i++) {
      met[kept] = met[i];
      kept += nears[i - first] > hidden[sector] ? 0 : 1;
    }
    ends[sector + 1] = kept;
  }

  /** Whether the region is seen from this very point. */
  public boolean isFrom(double x, double y) {
    return atX == x && atY == y;
  }

  /** As {@link Obstacles#transmittance} from the standpoint to a point. */
  public double transmittance(double x, double y) {
    return transmittance(x, y, Double.NaN, 0, 0);
  }

  /**
   * As {@link Obstacles#transmittance(double, double, double, double, double, double, double)} from
   * the standpoint.
   *
   * @param z the height of the eye, metres; NaN in a flat world
   * @param low the least height of what is looked at, metres
   * @param high the greatest, metres
   */
  public double transmittance(double x, double y, double z, double low, double high) {
    double dx = x - atX;
    double dy = y - atY;
    int sector = (int) (Sector.measure(dx, dy) * (sectors / Sector.ROUND)) & sectors - 1;
    double square = dx * dx + dy * dy;
    if (square < touched[sector]) {
      return 1;
    }
    return square > hidden[sector] ? 0 : product(sector, x, y, z, low, high);
  }

  /** An obstacle that is not full is asked as a whole: a line may come down inside of it. */
  private double product(int sector, double x, double y, double z, double low, double high) {
    double product = 1;
    int tested = -1;
    for (int i = ends[sector]; i < ends[sector + 1] && product > 0; i++) {
      int obstacle = pieces.obstacle[met[i] < 0 ? ~met[i] : met[i]];
      if (obstacle != tested) {
        boolean full = pieces.full[obstacle];
        boolean touches =
            full
                ? met[i] < 0 || pieces.touches(met[i], atX, atY, x, y)
                : obstacles.all().get(obstacle).touches(atX, atY, z, x, y, low, high);
        product *= touches ? pieces.transmittance[obstacle] : 1;
        tested = touches || !full ? obstacle : tested;
      }
    }
    return product;
  }
}
