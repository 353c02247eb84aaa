package org.hificamsim.agents.voting;

import org.hificamsim.core.policy.NetworkView;

/**
 * Each online camera's k nearest online cameras by Euclidean distance, of equally near ones those
 * with the lower numbers (section 7.4.5); fewer than k in a small network.
 */
final class NearestCameras {
  private final int most;
  private final int[] neighbours;
  private final double[] squaredDistances;
  private final int[] counts;

  NearestCameras(NetworkView network, int k) {
    most = Math.min(k, Math.max(0, network.cameras() - 1));
    neighbours = new int[Math.multiplyExact(network.cameras(), most)];
    squaredDistances = new double[most];
    counts = new int[network.cameras()];
  }

  /** Finds the neighbours anew. */
  void find(NetworkView network) {
    for (int camera = 0; camera < network.cameras(); camera++) {
      counts[camera] = 0;
      for (int other = 0; other < network.cameras() && network.online(camera); other++) {
        if (other != camera && network.online(other)) {
          insert(network, camera, other);
        }
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

  private void insert(NetworkView network, int camera, int other) {
    double dx = network.cameraX(other) - network.cameraX(camera);
    double dy = network.cameraY(other) - network.cameraY(camera);
    double squared = dx * dx + dy * dy;
    int first = camera * most;
    int at = counts[camera];
    while (at > 0 && squared < squaredDistances[at - 1]) {
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
}
