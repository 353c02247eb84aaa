package org.hificamsim.network.agent;

import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * The keys of CamSim's maps of targets: a list of one number, the features of a target (behaviour
 * 4.4). Targets with the same features have the same key.
 */
public final class TargetKeys {
  private final int[] keys;
  private final int[] hashes;

  /**
   * Creates the keys of all targets.
   *
   * @param features the features of each target, including those that events will add
   */
  public TargetKeys(double[] features) {
    keys = new int[features.length];
    hashes = new int[features.length];
    Map<List<Double>, Integer> firstTargets = new HashMap<>();
    for (int target = 0; target < features.length; target++) {
      List<Double> key = List.of(features[target]);
      firstTargets.putIfAbsent(key, target);
      keys[target] = firstTargets.get(key);
      hashes[target] = key.hashCode();
    }
  }

  int count() {
    return keys.length;
  }

  boolean equal(int target, int other) {
    return keys[target] == keys[other];
  }

  int hash(int target) {
    return hashes[target];
  }
}
