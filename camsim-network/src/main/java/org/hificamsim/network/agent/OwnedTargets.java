package org.hificamsim.network.agent;

/**
 * The targets that a camera tracks, in the order of CamSim's map keyed by features (behaviour 4.4).
 * A target that appears with the features of one that has gone takes its place.
 */
final class OwnedTargets {
  private final double[] features;
  private final HashOrder order = new HashOrder();

  /**
   * @param features of all targets that there will ever be
   */
  OwnedTargets(double[] features) {
    this.features = features;
  }

  void add(int target) {
    int place = place(target);
    if (place >= 0) {
      order.replace(place, target);
    } else {
      order.add(target, HashOrder.hashOfFeatures(features[target]));
    }
  }

  void remove(int target) {
    int place = place(target);
    if (place >= 0) {
      order.removeAt(place);
    }
  }

  boolean contains(int target) {
    return place(target) >= 0;
  }

  /** The targets, for reading only. */
  HashOrder order() {
    return order;
  }

  private int place(int target) {
    for (int i = 0; i < order.size(); i++) {
      if (features[order.get(i)] == features[target]) {
        return i;
      }
    }
    return -1;
  }
}
