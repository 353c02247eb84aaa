package org.hificamsim.agents.optimal;

import org.hificamsim.agents.choice.LevelTable;
import org.hificamsim.core.policy.NetworkView;

/** The levels that each camera may take at the next step, widest or narrowest first. */
final class CandidateLevels {
  private final LevelTable table;
  private final int[] levels;
  private final int[] counts;

  CandidateLevels(NetworkView network) {
    table = new LevelTable(network);
    levels = new int[table.size()];
    counts = new int[network.cameras()];
  }

  /** Takes all candidates from a camera. */
  void clear(int camera) {
    counts[camera] = 0;
  }

  /** Adds a candidate after the camera's others. */
  void add(int camera, int level) {
    levels[table.offset(camera) + counts[camera]] = level;
    counts[camera]++;
  }

  int count(int camera) {
    return counts[camera];
  }

  /** The camera's i-th candidate. */
  int level(int camera, int i) {
    return levels[table.offset(camera) + i];
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
        System.arraycopy(levels, first + i + 1, levels, first + i, counts[camera] - i);
      }
    }
  }

  private boolean dominated(NetworkView network, int camera, int i) {
    for (int other = 0; other < counts[camera]; other++) {
      if (other != i
          && network.oracle().dominates(camera, level(camera, other), level(camera, i))) {
        return true;
      }
    }
    return false;
  }
}
