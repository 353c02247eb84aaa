package org.hificamsim.agents.cooperative;

import java.util.Arrays;
import org.hificamsim.core.policy.NetworkView;

/** Which cells of a grid each camera sees in each of its views, and how likely it detects there. */
final class CellSight {
  private static final double[] SAMPLED = {0.25, 0.75};
  private static final double SHARE = 1.0 / (SAMPLED.length * SAMPLED.length);

  private final Grid grid;
  private int[][][] cells; // by camera and view
  private float[][][] chances;

  // Room for one camera.
  private double[] now = {};
  private double[] sums = {};
  private int[] counts = {};
  private int[][] found = {};
  private float[][] foundChances = {};

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
    boolean[] free = site.free();
    int views = network.views(camera);
    makeRoom(views);
    Arrays.fill(counts, 0, views, 0);
    for (int cell = 0; cell < free.length; cell++) {
      if (free[cell] && sum(network, site, size, camera, cell)) {
        for (int view = 0; view < views; view++) {
          if (sums[view] > 0) {
            foundChances[view][counts[view]] = (float) sums[view];
            found[view][counts[view]++] = cell;
          }
        }
      }
    }
    cells[camera] = new int[views][];
    chances[camera] = new float[views][];
    for (int view = 0; view < views; view++) {
      cells[camera][view] = Arrays.copyOf(found[view], counts[view]);
      chances[camera][view] = Arrays.copyOf(foundChances[view], counts[view]);
    }
  }

  private void makeRoom(int views) {
    if (found.length < views) {
      now = new double[views];
      sums = new double[views];
      counts = new int[views];
      found = new int[views][grid.cells()];
      foundChances = new float[views][grid.cells()];
    }
  }

  /** The mean chances over a cell. */
  private boolean sum(NetworkView network, Site site, double size, int camera, int cell) {
    boolean any = false;
    Arrays.fill(sums, 0);
    for (double right : SAMPLED) {
      for (double up : SAMPLED) {
        double x = grid.x(cell, right);
        double y = grid.y(cell, up);
        if (site.chances(network, camera, x, y, size, now)) {
          any = true;
          for (int view = 0; view < network.views(camera); view++) {
            sums[view] += SHARE * now[view];
          }
        }
      }
    }
    return any;
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
