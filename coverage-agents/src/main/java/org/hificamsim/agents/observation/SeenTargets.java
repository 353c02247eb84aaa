package org.hificamsim.agents.observation;

import java.util.Arrays;
import org.hificamsim.core.policy.NetworkView;

/** The targets that a camera sees, the nearest first; of equally near ones the lower number. */
final class SeenTargets {
  private static final int SIZE = 3; // among the numbers of a target

  private final int wanted;
  private final Shares ofCameras;
  private final int[] who;
  private final double[] ahead;
  private final double[] right;
  private final double[] squared;

  SeenTargets(NetworkView network, ObservationLayout layout) {
    wanted = layout.targets();
    ofCameras = new Shares(network.cameras());
    who = new int[network.targets()];
    ahead = new double[who.length];
    right = new double[who.length];
    squared = new double[who.length];
  }

  /**
   * Writes the nearest ones, and 0 where there are fewer than there is room for.
   *
   * @param view that the camera sees through, -1 for none
   */
  void write(
      NetworkView network, int camera, int view, ViewFeatures views, float[] out, int first) {
    int count = wanted == 0 ? 0 : find(network, camera);
    int shown = Math.min(count, wanted);
    int at = first;
    for (int i = 0; i < shown; i++) {
      bringNearest(i, count);
      write(network, camera, i, views.perReach(camera, view), out, at);
      double angle = network.targetSize(who[i]) / Math.sqrt(squared[i]);
      out[at + SIZE] = Bounds.share(angle * views.perAngle(camera, view));
      at += ObservationLayout.TARGET.size();
    }
    Arrays.fill(out, at, first + wanted * ObservationLayout.TARGET.size(), 0);
  }

  private int find(NetworkView network, int camera) {
    int count = network.findSeen(camera, who, ahead, right);
    for (int i = 0; i < count; i++) {
      squared[i] = ahead[i] * ahead[i] + right[i] * right[i];
    }
    return count;
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

  private void write(NetworkView network, int camera, int i, double perReach, float[] out, int at) {
    int target = who[i];
    out[at] = 1;
    out[at + 1] = Bounds.signed(ahead[i] * perReach);
    out[at + 2] = Bounds.signed(right[i] * perReach);
    out[at + 4] = Bounds.share(network.seenConfidence(camera, target));
    out[at + 5] = ofCameras.of(network.coverage(target));
  }
}
