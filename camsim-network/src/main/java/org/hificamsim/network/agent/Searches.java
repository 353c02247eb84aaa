package org.hificamsim.network.agent;

/** The targets that a camera looks for, and for whom, in the order of insertion (behaviour 4.6). */
final class Searches {
  /** Nobody owns the target: whoever sees it first may have it. */
  static final int NOBODY = -1;

  private final InsertionOrder order;
  private final int[] searcher;

  Searches(int targets) {
    order = new InsertionOrder(targets);
    searcher = new int[targets];
  }

  /** Looks for a target from now on, for this camera or for {@link #NOBODY}. */
  void put(int target, int forCamera) {
    order.add(target);
    searcher[target] = forCamera;
  }

  void remove(int target) {
    order.remove(target);
  }

  boolean contains(int target) {
    return order.contains(target);
  }

  /** For whom the camera looks for a target that it looks for. */
  int searcher(int target) {
    return searcher[target];
  }

  int first() {
    return order.first();
  }

  int next(int target) {
    return order.next(target);
  }
}
