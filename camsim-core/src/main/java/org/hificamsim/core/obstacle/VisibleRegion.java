package org.hificamsim.core.obstacle;

/**
 * What can be seen from one standpoint past obstacles that do not move: the same answers as {@link
 * Obstacles} gives, to the bit, from a look-up by direction. Made once for a standpoint, by a sweep
 * all round it; asking allocates nothing, but for points so near to a border that doubles do not
 * tell. Any number of threads may ask.
 *
 * <p>All round is cut into equal sectors ({@link Sector}). A sector knows from the sweep up to
 * which distance nothing is met in it, from which distance on everything is hidden by something
 * solid that spans it, and what lies between: only for points between is that asked, exactly.
 */
public final class VisibleRegion {
  /** Of a sector's limits: the squared distance below which nothing is touched. */
  static final int TOUCHED = 0;

  /** The squared distance above which everything is hidden. */
  static final int HIDDEN = 1;

  /** How many limits a sector has. */
  static final int LIMITS = 2;

  private final double atX;
  private final double atY;
  private final Pieces pieces;
  private final Obstacles obstacles;
  private final double sectorsPerMeasure;
  private final int lastSector;
  private final float[] limits;

  /** By sector: where what is met in it begins; one more is the end of the last. */
  private final int[] ends;

  /** What is met, see {@link RegionSweep}. */
  private final int[] met;

  private VisibleRegion(Obstacles obstacles, double x, double y, RegionSweep sweep) {
    this.obstacles = obstacles;
    this.pieces = obstacles.pieces();
    this.atX = x;
    this.atY = y;
    this.limits = sweep.limits();
    this.ends = sweep.ends();
    this.met = sweep.met();
    this.lastSector = limits.length / LIMITS - 1;
    this.sectorsPerMeasure = (lastSector + 1) / Sector.ROUND;
  }

  /** The region seen from a point. */
  public static VisibleRegion of(Obstacles obstacles, double x, double y) {
    return new VisibleRegion(obstacles, x, y, new RegionSweep(obstacles, x, y));
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
    int sector = sector(dx, dy);
    double square = dx * dx + dy * dy;
    if (square < limits[LIMITS * sector + TOUCHED]) {
      return 1;
    }
    return square > limits[LIMITS * sector + HIDDEN] ? 0 : product(sector, x, y, z, low, high);
  }

  /** An obstacle that is not full is asked as a whole: a line may come down inside of it. */
  private double product(int sector, double x, double y, double z, double low, double high) {
    double product = 1;
    int tested = -1;
    for (int i = ends[sector]; i < ends[sector + 1] && product > 0; i++) {
      int obstacle = pieces.obstacle[RegionSweep.piece(met[i])];
      if (obstacle != tested) {
        boolean full = pieces.full[obstacle];
        boolean touched =
            full
                ? RegionSweep.atStandpoint(met[i]) || pieces.touches(met[i], atX, atY, x, y)
                : obstacles.all().get(obstacle).touches(atX, atY, z, x, y, low, high);
        product *= touched ? pieces.transmittance[obstacle] : 1;
        tested = touched || !full ? obstacle : tested;
      }
    }
    return product;
  }

  /** The sector of a direction; the first where there is none. */
  private int sector(double dx, double dy) {
    return (int) (Sector.measure(dx, dy) * sectorsPerMeasure) & lastSector;
  }
}
