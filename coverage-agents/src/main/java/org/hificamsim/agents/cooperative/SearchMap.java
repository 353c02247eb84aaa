package org.hificamsim.agents.cooperative;

import java.util.Arrays;

/**
 * The number of unseen targets expected in each cell of a grid. It spreads to neighbouring cells,
 * falls where cameras look, takes up targets that were lost, and relaxes towards a learned
 * occupancy: the average number of targets seen per look at the cell and its neighbours.
 *
 * <p>All arrays are by cell. In each step call {@link #look}, {@link #countSighting} and {@link
 * #absorb} for all events, then {@link #step}.
 */
final class SearchMap {
  /** The number of steps from one estimate of the occupancy to the next. */
  private static final int STEPS_PER_ESTIMATE = 10;

  /** The least part of the occupancy that counts as unseen, however many targets are known. */
  private static final double MIN_UNSEEN_SHARE = 0.1;

  /** The part of a cell's targets that a certain look finds. */
  private static final double FOUND_SHARE = 0.95;

  private final Parameters parameters;
  private final Grid grid;
  private final boolean[] free;
  private final int freeCells;
  private final double[] unseenTargets;
  private final double[] targetsBefore;
  private final double[] looks;
  private final double[] sightings;
  private final double[] occupancy;

  /** The chance that no look in this step finds a target in the cell, by cell. */
  private final double[] missChances;

  /** The mean number of targets in a free cell. */
  private double meanOccupancy;

  private int steps;

  /**
   * @param free for each cell, whether a target can be in it
   * @param expected number of targets at the beginning
   */
  SearchMap(Parameters parameters, Grid grid, boolean[] free, double expected) {
    this.parameters = parameters;
    this.grid = grid;
    this.free = free;
    int count = 0;
    for (boolean isFree : free) {
      count += isFree ? 1 : 0;
    }
    freeCells = Math.max(1, count);
    meanOccupancy = expected / freeCells;
    unseenTargets = new double[free.length];
    targetsBefore = new double[free.length];
    looks = new double[free.length];
    sightings = new double[free.length];
    occupancy = new double[free.length];
    missChances = new double[free.length];
    for (int cell = 0; cell < free.length; cell++) {
      occupancy[cell] = free[cell] ? meanOccupancy : 0;
    }
    System.arraycopy(occupancy, 0, unseenTargets, 0, unseenTargets.length);
    Arrays.fill(missChances, 1);
  }

  /** Returns the expected number of targets in each cell that no camera sees. */
  double[] unseenTargets() {
    return unseenTargets;
  }

  /**
   * The part of a cell's targets that stays unseen when a camera looks at the cell.
   *
   * @param chance the chance that the camera detects a target there
   */
  static double leftAfterLook(double chance) {
    return 1 - FOUND_SHARE * chance;
  }

  /** Records that a camera looks at cells, with its chances to detect a target in each. */
  void look(int[] cells, float[] chances, LearnedSight learned, int camera) {
    for (int i = 0; i < cells.length; i++) {
      missChances[cells[i]] *= 1 - chances[i] * learned.share(camera, cells[i]);
    }
  }

  /** Counts a target that is seen at a point; to be called once for each sighting. */
  void countSighting(double x, double y) {
    sightings[grid.cell(x, y)]++;
  }

  /** Adds a target that is no longer tracked, with the weight that its track has lost. */
  void absorb(double x, double y, double weight) {
    unseenTargets[grid.cell(x, y)] += weight;
  }

  /**
   * Ends a step.
   *
   * @param spread the part of a cell's targets that moves to its neighbours in a step
   * @param knownTargets the number of targets that are tracked, and so not unseen
   */
  void step(double spread, double knownTargets) {
    spread(spread);
    double allTargets = Math.max(knownTargets, meanOccupancy * freeCells);
    double unseenShare = Math.max(MIN_UNSEEN_SHARE, 1 - knownTargets / allTargets);
    for (int cell = 0; cell < unseenTargets.length; cell++) {
      double look = 1 - missChances[cell];
      looks[cell] += look;
      unseenTargets[cell] *= leftAfterLook(look);
      unseenTargets[cell] +=
          parameters.relax() * (unseenShare * occupancy[cell] - unseenTargets[cell]);
      missChances[cell] = 1;
    }
    if (steps++ % STEPS_PER_ESTIMATE == 0) {
      estimateOccupancy();
    }
  }

  private void spread(double part) {
    System.arraycopy(unseenTargets, 0, targetsBefore, 0, unseenTargets.length);
    double partForEach = part / 4;
    for (int row = 0; row < grid.rows(); row++) {
      for (int column = 0; column < grid.columns(); column++) {
        int cell = row * grid.columns() + column;
        if (free[cell] && targetsBefore[cell] > 0) {
          double moved = partForEach * targetsBefore[cell];
          move(cell, column > 0, cell - 1, moved);
          move(cell, column + 1 < grid.columns(), cell + 1, moved);
          move(cell, row > 0, cell - grid.columns(), moved);
          move(cell, row + 1 < grid.rows(), cell + grid.columns(), moved);
        }
      }
    }
  }

  private void move(int from, boolean isInside, int to, double moved) {
    if (isInside && free[to]) {
      unseenTargets[from] -= moved;
      unseenTargets[to] += moved;
    }
  }

  /** Estimates each cell's occupancy from looks at it and its neighbours, and the mean of all. */
  private void estimateOccupancy() {
    double sum = 0;
    for (int row = 0; row < grid.rows(); row++) {
      for (int column = 0; column < grid.columns(); column++) {
        int cell = row * grid.columns() + column;
        occupancy[cell] = free[cell] ? occupancy(row, column) : 0;
        sum += occupancy[cell];
      }
    }
    meanOccupancy = sum / freeCells;
  }

  private double occupancy(int row, int column) {
    double weightedSightings = parameters.prior() * meanOccupancy;
    double weightedLooks = parameters.prior();
    int left = Math.max(0, column - 1);
    int right = Math.min(grid.columns() - 1, column + 1);
    for (int r = Math.max(0, row - 1); r <= Math.min(grid.rows() - 1, row + 1); r++) {
      for (int cell = r * grid.columns() + left; cell <= r * grid.columns() + right; cell++) {
        weightedSightings += sightings[cell];
        weightedLooks += looks[cell];
      }
    }
    return weightedSightings / weightedLooks;
  }
}
