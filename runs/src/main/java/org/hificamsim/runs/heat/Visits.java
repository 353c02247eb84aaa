package org.hificamsim.runs.heat;

import org.hificamsim.core.policy.NetworkView;

/** Where targets were, and how many cameras detected them there. */
final class Visits {
  private final FieldCells cells;
  private final long[] count;
  private final long[] detections;
  private final long[] uncovered;

  Visits(FieldCells cells) {
    this.cells = cells;
    this.count = new long[cells.count()];
    this.detections = new long[cells.count()];
    this.uncovered = new long[cells.count()];
  }

  /** Adds the targets present, where the cameras observed them. */
  void add(NetworkView network) {
    for (int target = 0; target < network.targets(); target++) {
      if (network.present(target)) {
        int k = network.coverage(target);
        add(cells.at(network.oracle().targetX(target), network.oracle().targetY(target)), k);
      }
    }
  }

  private void add(int cell, int k) {
    if (cell >= 0) {
      count[cell]++;
      detections[cell] += k;
      uncovered[cell] += k == 0 ? 1 : 0;
    }
  }

  long count(int cell) {
    return count[cell];
  }

  double meanK(int cell) {
    return (double) detections[cell] / count[cell];
  }

  double covered0(int cell) {
    return (double) uncovered[cell] / count[cell];
  }
}
