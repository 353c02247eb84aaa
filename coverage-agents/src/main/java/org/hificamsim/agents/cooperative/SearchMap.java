package org.hificamsim.agents.cooperative;

import java.util.Arrays;

/**
 * Where targets may be that nobody sees: how many are expected in each cell of a grid. It spreads,
 * falls where cameras look and find nothing, takes up targets that were lost, and relaxes towards
 * an occupancy that is learned: targets seen a look, of a cell and its neighbours.
 */
final class SearchMap {
  private static final int AVERAGING = 10; // steps from one estimate of the occupancy to the next
  private static final double LEAST_SHARE = 0.1; // of the occupancy, however many are known
  private static final double FOUND = 0.95; // part of a cell's targets that a look finds

  private final Parameters parameters;
  private final Grid grid;
  private final boolean[] free;
  private final int freeCells;
  private final double[] unseen;
  private final double[] before;
  private final double[] looks;
  private final double[] sightings;
  private final double[] occupancy;
  private final double[] missed; // in this step: the chance that no look at a cell finds a target
  private double mean; // targets a free cell
  private int steps;

  /**
   * @param free which cells a target can be in
   * @param expected number of targets at first
   */
  SearchMap(Parameters parameters, Grid grid, boolean[] free, double expected) {
    this.parameters = parameters;
    this.grid = grid;
    this.free = free;
    int count = 0;
    for (boolean one : free) {
      count += one ? 1 : 0;
    }
    freeCells = Math.max(1, count);
    mean = expected / freeCells;
    unseen = new double[free.length];
    before = new double[free.length];
    looks = new double[free.length];
    sightings = new double[free.length];
    occupancy = new double[free.length];
    missed = new double[free.length];
    for (int cell = 0; cell < free.length; cell++) {
      occupancy[cell] = free[cell] ? mean : 0;
    }
    System.arraycopy(occupancy, 0, unseen, 0, unseen.length);
    Arrays.fill(missed, 1);
  }

  /** Targets expected in each cell that nobody sees. */
  double[] unseen() {
    return unseen;
  }

  /**
   * The part of a cell's targets that is left unseen when a camera looks at it.
   *
   * @param chance that it detects a target there
   */
  static double leftAfterLook(double chance) {
    return 1 - FOUND * chance;
  }

  /** A camera looks at cells. */
  void look(int[] cells, float[] chances, LearnedSight learned, int camera) {
    for (int i = 0; i < cells.length; i++) {
      missed[cells[i]] *= 1 - chances[i] * learned.share(camera, cells[i]);
    }
  }

  /** A target is seen in this step; once for each. */
  void sight(double x, double y) {
    sightings[grid.cell(x, y)]++;
  }

  /** A target that was expected at a place is not there, or nobody knows. */
  void absorb(double x, double y, double weight) {
    unseen[grid.cell(x, y)] += weight;
  }

  /**
   * Goes on by a step.
   *
   * @param spread the part of a cell that goes to its neighbours in a step
   * @param known how many targets are known: the others alone are unseen
   */
  void step(double spread, double known) {
    spread(spread);
    double share = Math.max(LEAST_SHARE, 1 - known / Math.max(known, mean * freeCells));
    for (int cell = 0; cell < unseen.length; cell++) {
      double looked = 1 - missed[cell];
      looks[cell] += looked;
      unseen[cell] *= leftAfterLook(looked);
      unseen[cell] += parameters.relax() * (share * occupancy[cell] - unseen[cell]);
      missed[cell] = 1;
    }
    if (steps++ % AVERAGING == 0) {
      average();
    }
  }

  private void spread(double part) {
    System.arraycopy(unseen, 0, before, 0, unseen.length);
    double toEach = part / 4;
    for (int row = 0; row < grid.rows(); row++) {
      for (int column = 0; column < grid.columns(); column++) {
        int cell = row * grid.columns() + column;
        if (free[cell] && before[cell] > 0) {
          double sent = toEach * before[cell];
          give(cell, column > 0, cell - 1, sent);
          give(cell, column + 1 < grid.columns(), cell + 1, sent);
          give(cell, row > 0, cell - grid.columns(), sent);
          give(cell, row + 1 < grid.rows(), cell + grid.columns(), sent);
        }
      }
    }
  }

  private void give(int from, boolean inside, int to, double sent) {
    if (inside && free[to]) {
      unseen[from] -= sent;
      unseen[to] += sent;
    }
  }

  /** The occupancy of each cell from its own and its neighbours' looks, and of all together. */
  private void average() {
    double sum = 0;
    for (int row = 0; row < grid.rows(); row++) {
      for (int column = 0; column < grid.columns(); column++) {
        int cell = row * grid.columns() + column;
        occupancy[cell] = free[cell] ? occupancy(row, column) : 0;
        sum += occupancy[cell];
      }
    }
    mean = sum / freeCells;
  }

  private double occupancy(int row, int column) {
    double seen = parameters.prior() * mean;
    double looked = parameters.prior();
    int left = Math.max(0, column - 1);
    int right = Math.min(grid.columns() - 1, column + 1);
    for (int r = Math.max(0, row - 1); r <= Math.min(grid.rows() - 1, row + 1); r++) {
      for (int cell = r * grid.columns() + left; cell <= r * grid.columns() + right; cell++) {
        seen += sightings[cell];
        looked += looks[cell];
      }
    }
    return seen / looked;
  }
}
