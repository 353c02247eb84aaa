package org.hificamsim.agents.cooperative;

/**
 * Learns how much a camera really sees in each cell, as a share of what its map and its detection
 * model promise: the mean of a bandit whose arms are the cells. The share falls when a camera does
 * not see a target that should be in its view, because a wall is not on the map, or the detection
 * model promises too much.
 */
final class LearnedSight {
  /** The number of targets, seen as promised, that the model's promise counts as. */
  private static final double TRUST = 3;

  private final boolean learns;
  private final Grid grid;
  private final double[][] promised;
  private final double[][] seen;

  /**
   * @param learns whether anything is learned; if not, all shares are 1
   */
  LearnedSight(boolean learns, Grid grid, int cameras) {
    this.learns = learns;
    this.grid = grid;
    promised = new double[learns ? cameras : 0][grid.cells()];
    seen = new double[learns ? cameras : 0][grid.cells()];
  }

  /**
   * Learns whether a camera saw a target in its view.
   *
   * @param chance the model's chance that the camera sees the target
   */
  void learn(int camera, double x, double y, double chance, boolean isSeen) {
    if (learns) {
      int cell = grid.cell(x, y);
      promised[camera][cell] += chance;
      seen[camera][cell] += isSeen ? chance : 0;
    }
  }

  /** The learned share of what the model promises at a point, in [0, 1]. */
  double share(int camera, double x, double y) {
    return learns ? share(camera, grid.cell(x, y)) : 1;
  }

  /** The learned share of what the model promises in a cell, in [0, 1]. */
  double share(int camera, int cell) {
    return learns ? (TRUST + seen[camera][cell]) / (TRUST + promised[camera][cell]) : 1;
  }
}
