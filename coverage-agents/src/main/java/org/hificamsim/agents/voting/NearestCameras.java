package org.hificamsim.agents.voting;

import java.util.DoubleSummaryStatistics;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.space.PointGrid;

/**
 * Each online camera's k nearest online cameras by Euclidean distance, of equally near ones those
 * with the lower numbers (section 7.4.5); fewer than k in a small network.
 */
final class NearestCameras {
  /** A little below 1, lest rounding takes what lies just outside a square for further away. */
  private static final double SURE = 1 - 1e-9;

  /** Cameras in a cell of the grid, about. */
  private static final double PER_CELL = 2;

  private final PointGrid places;
  private final double firstHalf;
  private final int most;
  private final int[] neighbours;
  private final double[] squaredDistances;
  private final int[] counts;

  NearestCameras(NetworkView network, int k) {
    most = Math.min(k, Math.max(0, network.cameras() - 1));
    neighbours = new int[Math.multiplyExact(network.cameras(), most)];
    squaredDistances = new double[most];
    counts = new int[network.cameras()];
    DoubleSummaryStatistics x = range(network, network::cameraX);
    DoubleSummaryStatistics y = range(network, network::cameraY);
    double width = Math.max(x.getMax() - x.getMin(), 1);
    double height = Math.max(y.getMax() - y.getMin(), 1);
    double perCamera = width * height / Math.max(1, network.cameras());
    double side = Math.sqrt(PER_CELL * perCamera);
    places = PointGrid.over(x.getMin(), y.getMin(), width, height, side, network.cameras());
    firstHalf = Math.max(side, Math.sqrt(perCamera * most) / 2);
  }

  private static DoubleSummaryStatistics range(NetworkView network, IntToDoubleFunction of) {
    return IntStream.range(0, network.cameras()).mapToDouble(of).summaryStatistics();
  }

  /** Finds the neighbours anew. */
  void find(NetworkView network) {
    places.clear();
    for (int camera = 0; camera < network.cameras(); camera++) {
      if (network.online(camera)) {
        places.add(camera, network.cameraX(camera), network.cameraY(camera));
      }
    }
    places.sort();
    for (int camera = 0; camera < network.cameras(); camera++) {
      counts[camera] = 0;
      if (network.online(camera) && most > 0) {
        find(camera, network.cameraX(camera), network.cameraY(camera));
      }
    }
  }

  int count(int camera) {
    return counts[camera];
  }

  /** The camera's i-th nearest neighbour. */
  int neighbour(int camera, int i) {
    return neighbours[camera * most + i];
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
    int left = places.column(x - half);
    int right = places.column(x + half);
    int bottom = places.row(y - half);
    int top = places.row(y + half);
    for (int row = bottom; row <= top; row++) {
      for (int i = places.start(row, left); i < places.end(row, right); i++) {
        if (places.point(i) != camera) {
          insert(camera, places.point(i), places.x(i) - x, places.y(i) - y);
        }
      }
    }
    boolean all = left == 0 && bottom == 0 && places.isLast(right, top);
    boolean enough = counts[camera] == most && squaredDistances[most - 1] < half * half * SURE;
    return all || enough;
  }

  private void insert(int camera, int other, double dx, double dy) {
    double squared = dx * dx + dy * dy;
    int first = camera * most;
    int at = counts[camera];
    while (at > 0 && nearer(squared, other, at - 1, first)) {
      if (at < most) {
        squaredDistances[at] = squaredDistances[at - 1];
        neighbours[first + at] = neighbours[first + at - 1];
      }
      at--;
    }
    if (at < most) {
      squaredDistances[at] = squared;
      neighbours[first + at] = other;
      counts[camera] = Math.min(most, counts[camera] + 1);
    }
  }

  private boolean nearer(double squared, int other, int than, int first) {
    return squared < squaredDistances[than]
        || (squared == squaredDistances[than] && other < neighbours[first + than]);
  }
}
