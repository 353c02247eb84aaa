package org.hificamsim.agents.cooperative;

/**
 * What a camera sees of a cell, as a share of what its map and its detection model say: a bandit's
 * mean, with the places for arms. It falls where a camera does not see a target that should be in
 * its view, because a wall is not on the map, or the detection model promises too much.
 */
final class LearnedSight {
  /** What the model counts as: this many targets that were seen as promised. */
  private static final double TRUST = 3;

  private final Grid grid;
  private final double[][] promised; // by camera and cell: null where nothing is learned
  private final double[][] seen;

  LearnedSight(boolean learns, Grid grid, int cameras) {
    this.grid = grid;
    promised = learns ? new double[cameras][grid.cells()] : null;
    seen = learns ? new double[cameras][grid.cells()] : null;
  }

  /**
   * A target is at a place in a camera's view.
   *
   * @param chance that the camera sees it, by the model
   */
  void see(int camera, double x, double y, double chance, boolean itDoes) {
    if (promised != null) {
      int cell = grid.cell(x, y);
      promised[camera][cell] += chance;
      seen[camera][cell] += itDoes ? chance : 0;
    }
  }

  /** The share of what the model says, in [0, 1]. */
  double share(int camera, double x, double y) {
    return promised == null ? 1 : share(camera, grid.cell(x, y));
  }

  double share(int camera, int cell) {
    return promised == null ? 1 : (TRUST + seen[camera][cell]) / (TRUST + promised[camera][cell]);
  }
}
