package org.hificamsim.agents.optimal;

import org.hificamsim.agents.toy.ToyNetwork;

/** Finds the best configuration of a toy network by trying all of them. */
final class BestConfiguration {
  private BestConfiguration() {}

  /** Returns the best k_min over all views from lowest to highest of each camera. */
  static int kMin(ToyNetwork network, int[] lowest, int[] highest) {
    int[] before = network.currentViews();
    int best = kMin(network, lowest, highest, 0);
    for (int camera = 0; camera < before.length; camera++) {
      network.setView(camera, before[camera]);
    }
    network.observe();
    return best;
  }

  private static int kMin(ToyNetwork network, int[] lowest, int[] highest, int camera) {
    if (camera == network.cameras()) {
      network.observe();
      return network.kMin();
    }
    int best = 0;
    for (int view = lowest[camera]; view <= highest[camera]; view++) {
      network.setView(camera, view);
      best = Math.max(best, kMin(network, lowest, highest, camera + 1));
    }
    return best;
  }
}
