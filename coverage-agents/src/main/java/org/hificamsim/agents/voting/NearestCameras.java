package org.hificamsim.agents.voting;

import java.util.DoubleSummaryStatistics;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.space.PointGrid;

/**
 * The k nearest online cameras of each online camera, by Euclidean distance (thesis 7.4.5). Equally
 * near cameras are sorted by their numbers. A small network has fewer than k neighbours.
 */
public final class NearestCameras {
  /**
   * A factor slightly below 1, so that rounding does not hide a nearer camera just outside a
   * square.
   */
  private static final double ROUNDING = 1 - 1e-9;

  /** The approximate number of cameras in a cell of the grid. */
  private static final double CAMERAS_PER_CELL = 2;

  private final PointGrid grid;
  private final double firstHalfSide;
  private final int k;
  private final int[] neighbours;
  private final double[] squaredDistances;
  private final int[] counts;
  private int revision;

  /**
   * @param wanted number of neighbours of each camera, 0 or more
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
    double areaPerCamera = width * height / Math.max(1, network.cameras());
    double side = Math.sqrt(CAMERAS_PER_CELL * areaPerCamera);
    grid = PointGrid.over(x.getMin(), y.getMin(), width, height, side, network.cameras());
    firstHalfSide = Math.max(side, Math.sqrt(areaPerCamera * k) / 2);
    find(network);
  }

  private static DoubleSummaryStatistics range(
      NetworkView network, IntToDoubleFunction coordinate) {
    return IntStream.range(0, network.cameras()).mapToDouble(coordinate).summaryStatistics();
  }

  /** Finds the neighbours again if cameras were added, moved or switched. */
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

  /** The greatest number of neighbours of a camera. */
  int maxNeighbours() {
    return k;
  }

  /** The number of neighbours of the camera. */
  public int count(int camera) {
    return counts[camera];
  }

  /** The camera's i-th nearest neighbour. */
  public int neighbour(int camera, int i) {
    return neighbours[camera * k + i];
  }

  /** Searches ever larger squares until no camera outside can be nearer than those found. */
  private void find(int camera, double x, double y) {
    double halfSide = firstHalfSide;
    while (!searchSquare(camera, x, y, halfSide)) {
      halfSide *= 2;
    }
  }

  /** Returns whether the neighbours are found: no camera outside the square is nearer. */
  private boolean searchSquare(int camera, double x, double y, double halfSide) {
    counts[camera] = 0;
    int left = grid.column(x - halfSide);
    int right = grid.column(x + halfSide);
    int bottom = grid.row(y - halfSide);
    int top = grid.row(y + halfSide);
    for (int row = bottom; row <= top; row++) {
      for (int i = grid.start(row, left); i < grid.end(row, right); i++) {
        if (grid.point(i) != camera) {
          insert(camera, grid.point(i), grid.x(i) - x, grid.y(i) - y);
        }
      }
    }
    boolean wholeGrid = left == 0 && bottom == 0 && grid.isLast(right, top);
    double safeSquare = halfSide * halfSide * ROUNDING;
    boolean enough = counts[camera] == k && squaredDistances[k - 1] < safeSquare;
    return wholeGrid || enough;
  }

  private void insert(int camera, int other, double dx, double dy) {
    double squared = dx * dx + dy * dy;
    int first = camera * k;
    int at = counts[camera];
    while (at > 0 && isNearer(squared, other, at - 1, first)) {
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

  /** Whether a camera is nearer than the i-th neighbour so far. */
  private boolean isNearer(double squared, int camera, int i, int first) {
    return squared < squaredDistances[i]
        || (squared == squaredDistances[i] && camera < neighbours[first + i]);
  }
}
