package org.hificamsim.agents.voting;

import java.util.DoubleSummaryStatistics;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.space.PointGrid;

/**
 * Each online camera's k nearest online cameras by Euclidean distance, of equally near ones those
 * with the lower numbers (thesis 7.4.5); fewer than k in a small network.
 */
public final class NearestCameras {
  /** A little below 1: rounding must not make what lies just outside a square seem further away. */
  private static final double SURE = 1 - 1e-9;

  /** Cameras in a cell of the grid, about. */
  private static final double PER_CELL = 2;

  private final PointGrid grid;
  private final double firstHalf;
  private final int k;
  private final int[] neighbours;
  private final double[] squaredDistances;
  private final int[] counts;
  private int revision;

  /**
   * @param wanted how many of each camera, 0 or more
   */
  public NearestCameras(NetworkView network, int wanted) {
    k = Math.min(wanted, Math.max(0, network.cameras() - 1));
    neighbours = new int[Math.multiplyExact(network.cameras(), k)];
    squaredDistances = new double[k];
    counts = new int[network.cameras()];
    DoubleSummaryStatistics x = range(network, network::cameraX);
    DoubleSummaryStatistics y = range(network, network::cameraY);
    double width = Math.max(x.getMax() - x.getMin(), 1);
    double height = Math.max(y.getMax() - y.getMin(), 1);
    double perCamera = width * height / Math.max(1, network.cameras());
    double side = Math.sqrt(PER_CELL * perCamera);
    grid = PointGrid.over(x.getMin(), y.getMin(), width, height, side, network.cameras());
    firstHalf = Math.max(side, Math.sqrt(perCamera * k) / 2);
    find(network);
  }

  private static DoubleSummaryStatistics range(NetworkView network, IntToDoubleFunction of) {
    return IntStream.range(0, network.cameras()).mapToDouble(of).summaryStatistics();
  }

  /** Finds the neighbours again where cameras have come, moved or failed. */
  public void update(NetworkView network) {
    if (network.revision() != revision) {
      find(network);
    }
  }

  private void find(NetworkView network) {
    revision = network.revision();
    grid.clear();
    for (int camera = 0; camera < network.cameras(); camera++) {
      if (network.online(camera)) {
        grid.add(camera, network.cameraX(camera), network.cameraY(camera));
      }
    }
    grid.sort();
    for (int camera = 0; camera < network.cameras(); camera++) {
      counts[camera] = 0;
      if (network.online(camera) && k > 0) {
        find(camera, network.cameraX(camera), network.cameraY(camera));
      }
    }
  }

  /** How many neighbours a camera has at most. */
  int most() {
    return k;
  }

  /** How many neighbours the camera has. */
  public int count(int camera) {
    return counts[camera];
  }

  /** The camera's i-th nearest neighbour. */
  public int neighbour(int camera, int i) {
    return neighbours[camera * k + i];
  }

  /** Looks at ever larger squares until none outside could be nearer than those found. */
  private void find(int camera, double x, double y) {
    double half = firstHalf;
    while (!lookWithin(camera, x, y, half)) {
      half *= 2;
    }
  }

  private boolean lookWithin(int camera, double x, double y, double half) {
    counts[camera] = 0;
    int left = grid.column(x - half);
    int right = grid.column(x + half);
    int bottom = grid.row(y - half);
    int top = grid.row(y + half);
    for (int row = bottom; row <= top; row++) {
      for (int i = grid.start(row, left); i < grid.end(row, right); i++) {
        if (grid.point(i) != camera) {
          insert(camera, grid.point(i), grid.x(i) - x, grid.y(i) - y);
        }
      }
    }
    boolean all = left == 0 && bottom == 0 && grid.isLast(right, top);
    boolean enough = counts[camera] == k && squaredDistances[k - 1] < half * half * SURE;
    return all || enough;
  }

  private void insert(int camera, int other, double dx, double dy) {
    double squared = dx * dx + dy * dy;
    int first = camera * k;
    int at = counts[camera];
    while (at > 0 && nearer(squared, other, at - 1, first)) {
      if (at < k) {
        squaredDistances[at] = squaredDistances[at - 1];
        neighbours[first + at] = neighbours[first + at - 1];
      }
      at--;
    }
    if (at < k) {
      squaredDistances[at] = squared;
      neighbours[first + at] = other;
      counts[camera] = Math.min(k, counts[camera] + 1);
    }
  }

  private boolean nearer(double squared, int other, int than, int first) {
    return squared < squaredDistances[than]
        || (squared == squaredDistances[than] && other < neighbours[first + than]);
  }
}
