package org.hificamsim.core.engine;

import java.util.Arrays;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.SeenPairs;

/**
 * Finds out which camera holds each target. A camera holds a target for as long as it covers it;
 * then the nearest camera that covers the target holds it, the one with the lowest number if
 * several are equally near.
 */
public final class Holders {
  /** The holder of a target that no camera holds. */
  public static final int NONE = -1;

  private final SeenPairs pairs = new SeenPairs();
  private int[] holders = {};
  private int[] nearestCameras = {};
  private double[] nearestDistances = {};

  /** Updates the holders by the observation of a step. */
  public void update(NetworkView network) {
    if (holders.length < network.targets()) {
      grow(network.targets());
    }
    Arrays.fill(nearestCameras, NONE);
    network.findSeen(pairs);
    for (int pair = 0; pair < pairs.count(); pair++) {
      consider(pairs.target(pair), pairs.camera(pair), pairs.distance(pair));
    }
    for (int target = 0; target < network.targets(); target++) {
      holders[target] = network.present(target) ? nearestCameras[target] : NONE;
    }
  }

  /** Considers a camera that covers a target; the present holder counts as the nearest. */
  private void consider(int target, int camera, double distance) {
    double rank = camera == holders[target] ? -1 : distance;
    if (nearestCameras[target] == NONE || rank < nearestDistances[target]) {
      nearestCameras[target] = camera;
      nearestDistances[target] = rank;
    }
  }

  private void grow(int targets) {
    int known = holders.length;
    holders = Arrays.copyOf(holders, targets);
    Arrays.fill(holders, known, targets, NONE);
    nearestCameras = new int[targets];
    nearestDistances = new double[targets];
  }

  /** The camera that holds a target, or {@link #NONE}. */
  public int holder(int target) {
    return holders[target];
  }
}
