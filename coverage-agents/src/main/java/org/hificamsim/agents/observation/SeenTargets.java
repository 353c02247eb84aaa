package org.hificamsim.agents.observation;

import org.hificamsim.core.policy.NetworkView;

/** The targets that a camera sees, the nearest first; of equally near ones the lower number. */
final class SeenTargets {
  private final int wanted;
  private final int[] who;
  private final double[] ahead;
  private final double[] right;
  private final double[] squared;

  SeenTargets(NetworkView network, int wanted) {
    this.wanted = wanted;
    who = new int[network.targets()];
    ahead = new double[who.length];
    right = new double[who.length];
    squared = new double[who.length];
  }

  /** Writes the nearest ones. */
  void write(NetworkView network, int camera, float[] out, int at) {
    int count = network.findSeen(camera, who, ahead, right);
    for (int i = 0; i < count; i++) {
      squared[i] = ahead[i] * ahead[i] + right[i] * right[i];
    }
    int shown = Math.min(count, wanted);
    if (shown > 0) {
      int view = network.seeing(camera);
      double perReach = 1 / network.reach(camera, view);
      double perAngle = 1 / network.zoom(camera, view).viewingAngle();
      for (int i = 0; i < shown; i++) {
        bringNearest(i, count);
        write(
            network, camera, i, perReach, perAngle, out, at + i * ObservationLayout.TARGET.size());
      }
    }
  }

  private void bringNearest(int to, int count) {
    int nearest = to;
    for (int i = to + 1; i < count; i++) {
      nearest = isNearer(i, nearest) ? i : nearest;
    }
    if (nearest != to) {
      swap(to, nearest);
    }
  }

  private boolean isNearer(int one, int other) {
    return squared[one] < squared[other]
        || (squared[one] == squared[other] && who[one] < who[other]);
  }

  private void swap(int one, int other) {
    int target = who[one];
    who[one] = who[other];
    who[other] = target;
    swap(ahead, one, other);
    swap(right, one, other);
    swap(squared, one, other);
  }

  private static void swap(double[] of, int one, int other) {
    double kept = of[one];
    of[one] = of[other];
    of[other] = kept;
  }

  private void write(
      NetworkView network,
      int camera,
      int i,
      double perReach,
      double perAngle,
      float[] out,
      int at) {
    int target = who[i];
    out[at] = 1;
    out[at + 1] = Bounds.signed(ahead[i] * perReach);
    out[at + 2] = Bounds.signed(right[i] * perReach);
    out[at + 3] = Bounds.share(network.targetSize(target) / Math.sqrt(squared[i]) * perAngle);
    out[at + 4] = Bounds.share(network.seenConfidence(camera, target));
    out[at + 5] = Bounds.share((double) network.coverage(target) / network.cameras());
  }
}
