package org.hificamsim.agents.cooperative;

import java.util.stream.IntStream;
import org.hificamsim.core.policy.NetworkView;

/**
 * The cells of a grid that each camera sees in each of its views, with its chance to detect there.
 */
final class CellSight {
  /** The parts of a cell's width and height at which it is sampled. */
  private static final double[] SAMPLED_PARTS = {0.25, 0.75};

  private static final double SAMPLE_WEIGHT = 1.0 / (SAMPLED_PARTS.length * SAMPLED_PARTS.length);

  private final Grid grid;

  /** The numbers of the cells that are seen, by camera and view. */
  private final int[][][] cells;

  /** The chances of the same cells, in the same order. */
  private final float[][][] chances;

  CellSight(Grid grid, int cameras) {
    this.grid = grid;
    this.cells = new int[cameras][][];
    this.chances = new float[cameras][][];
  }

  /** Computes what all cameras see of targets of this size, in metres. */
  void update(NetworkView network, Site site, double size) {
    for (int camera = 0; camera < cells.length; camera++) {
      update(network, site, size, camera);
    }
  }

  private void update(NetworkView network, Site site, double size, int camera) {
    int views = network.views(camera);
    double[][] means = new double[views][grid.cells()];
    double[] viewChances = new double[views];
    for (int cell = 0; cell < grid.cells(); cell++) {
      for (double partX : SAMPLED_PARTS) {
        for (double partY : SAMPLED_PARTS) {
          double x = grid.x(cell, partX);
          double y = grid.y(cell, partY);
          if (site.free()[cell] && site.chances(network, camera, x, y, size, viewChances)) {
            for (int view = 0; view < views; view++) {
              means[view][cell] += SAMPLE_WEIGHT * viewChances[view];
            }
          }
        }
      }
    }
    cells[camera] = new int[views][];
    chances[camera] = new float[views][];
    for (int view = 0; view < views; view++) {
      double[] mean = means[view];
      int[] seen = IntStream.range(0, mean.length).filter(cell -> mean[cell] > 0).toArray();
      cells[camera][view] = seen;
      chances[camera][view] = new float[seen.length];
      for (int i = 0; i < seen.length; i++) {
        chances[camera][view][i] = (float) mean[seen[i]];
      }
    }
  }

  /** The cells of which a camera sees any part in a view. */
  int[] cells(int camera, int view) {
    return cells[camera][view];
  }

  /** The chance to detect a target that is somewhere in the cell, for each of these cells. */
  float[] chances(int camera, int view) {
    return chances[camera][view];
  }
}
