package org.hificamsim.agents.optimal;

import org.hificamsim.agents.choice.ViewTable;
import org.hificamsim.core.policy.NetworkView;

/** The views that each camera may take at the next step, widest or narrowest first. */
final class CandidateViews {
  private final ViewTable table;
  private final int[] views;
  private final int[] counts;

  CandidateViews(NetworkView network) {
    table = new ViewTable(network);
    views = new int[table.size()];
    counts = new int[network.cameras()];
  }

  /** Takes all candidates from a camera. */
  void clear(int camera) {
    counts[camera] = 0;
  }

  /** Adds a candidate after the camera's others. */
  void add(int camera, int view) {
    views[table.offset(camera) + counts[camera]] = view;
    counts[camera]++;
  }

  int count(int camera) {
    return counts[camera];
  }

  /** The camera's i-th candidate. */
  int view(int camera, int i) {
    return views[table.offset(camera) + i];
  }

  /**
   * Takes from a camera the candidates that another one dominates; of candidates that dominate each
   * other the first stays.
   */
  void removeDominated(NetworkView network, int camera) {
    int first = table.offset(camera);
    for (int i = counts[camera] - 1; i >= 0; i--) {
      if (dominated(network, camera, i)) {
        counts[camera]--;
        System.arraycopy(views, first + i + 1, views, first + i, counts[camera] - i);
      }
    }
  }

  private boolean dominated(NetworkView network, int camera, int i) {
    for (int other = 0; other < counts[camera]; other++) {
      if (other != i && network.oracle().dominates(camera, view(camera, other), view(camera, i))) {
        return true;
      }
    }
    return false;
  }
}
