package org.hificamsim.core.engine;

import java.util.Arrays;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.SeenPairs;

/**
 * Which camera has each target. A camera that has a target keeps it for as long as it covers it;
 * then the nearest camera that covers it has it, of equally near ones the one with the lowest
 * number.
 */
public final class Holders {
  /** The camera of a target that no camera has. */
  public static final int NONE = -1;

  private final SeenPairs pairs = new SeenPairs();
  private int[] holders = {};
  private int[] nearestCameras = {};
  private double[] nearestDistances = {};

  /** Takes in the observation of a step, which may be the first one. */
  public void update(NetworkView network) {
    if (holders.length < network.targets()) {
      grow(network.targets());
    }
    Arrays.fill(nearestCameras, NONE);
    network.findSeen(pairs);
    for (int pair = 0; pair < pairs.count(); pair++) {
      offer(pairs.target(pair), pairs.camera(pair), pairs.distance(pair));
    }
    for (int target = 0; target < network.targets(); target++) {
      holders[target] = network.present(target) ? nearestCameras[target] : NONE;
    }
  }

  /** The camera that has the target already counts as the nearest. */
  private void offer(int target, int camera, double distance) {
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

  /** The camera that has a target, or {@link #NONE}. */
  public int holder(int target) {
    return holders[target];
  }
}
