package org.hificamsim.agents.cooperative;

import java.util.stream.IntStream;
import org.hificamsim.core.policy.NetworkView;

/** Which cells of a grid each camera sees in each of its views, and how likely it detects there. */
final class CellSight {
  private static final double[] SAMPLED = {0.25, 0.75};
  private static final double SHARE = 1.0 / (SAMPLED.length * SAMPLED.length);

  private final Grid grid;
  private int[][][] cells; // by camera and view
  private float[][][] chances;

  CellSight(Grid grid, int cameras) {
    this.grid = grid;
    this.cells = new int[cameras][][];
    this.chances = new float[cameras][][];
  }

  /** Finds out what all cameras see of targets of a size. */
  void find(NetworkView network, Site site, double size) {
    for (int camera = 0; camera < cells.length; camera++) {
      find(network, site, size, camera);
    }
  }

  private void find(NetworkView network, Site site, double size, int camera) {
    int views = network.views(camera);
    double[][] means = new double[views][grid.cells()];
    double[] now = new double[views];
    for (int cell = 0; cell < grid.cells(); cell++) {
      for (double right : SAMPLED) {
        for (double up : SAMPLED) {
          double x = grid.x(cell, right);
          double y = grid.y(cell, up);
          if (site.free()[cell] && site.chances(network, camera, x, y, size, now)) {
            for (int view = 0; view < views; view++) {
              means[view][cell] += SHARE * now[view];
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

  /** The cells that a camera sees something of in a view. */
  int[] cells(int camera, int view) {
    return cells[camera][view];
  }

  /** For each of these cells: how likely a target that is somewhere in it is detected. */
  float[] chances(int camera, int view) {
    return chances[camera][view];
  }
}
