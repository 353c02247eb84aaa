package org.hificamsim.network.agent;

/**
 * The targets that a camera owns, in the order of CamSim's hash map, and in that of a copy of it
 * (behaviour 4.4).
 */
public final class OwnedTargets {
  private static final int ABSENT = -1;

  private final TargetKeys keys;
  private final HashOrder order = new HashOrder();
  private final HashOrder copy = new HashOrder();

  /** Creates an empty set. */
  OwnedTargets(TargetKeys keys) {
    this.keys = keys;
  }

  void add(int target) {
    int index = index(target);
    if (index == ABSENT) {
      order.add(target, keys.hash(target));
    } else {
      order.replace(index, target);
    }
    updateCopy();
  }

  void remove(int target) {
    order.removeAt(index(target));
    updateCopy();
  }

  private void updateCopy() {
    if (!order.isOrderOfCopy()) {
      copy.refillFrom(order);
    }
  }

  boolean contains(int target) {
    return index(target) != ABSENT;
  }

  private int index(int target) {
    for (int i = 0; i < order.size(); i++) {
      if (keys.equal(target, order.get(i))) {
        return i;
      }
    }
    return ABSENT;
  }

  /** The number of targets. */
  public int count() {
    return order.size();
  }

  /** Returns a target by its index in the order of the map. */
  public int target(int index) {
    return order.get(index);
  }

  /** Returns a target by its index in the order of a copy of the map. */
  public int targetOfCopy(int index) {
    return order.isOrderOfCopy() ? order.get(index) : copy.get(index);
  }
}
