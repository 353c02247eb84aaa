package org.hificamsim.network.agent;

/** The targets that a camera looks for, and for whom, in the order of insertion (behaviour 4.6). */
public final class Searches {
  /** Nobody owns the target: whoever sees it first may have it. */
  public static final int NOBODY = -1;

  private final InsertionOrder order;
  private final int[] searcher;

  Searches(int targets) {
    order = new InsertionOrder(targets);
    searcher = new int[targets];
  }

  /** Looks for a target from now on, for this camera or for {@link #NOBODY}. */
  public void put(int target, int forCamera) {
    order.add(target);
    searcher[target] = forCamera;
  }

  /** Looks for the target no longer. */
  public void remove(int target) {
    order.remove(target);
  }

  public boolean contains(int target) {
    return order.contains(target);
  }

  /** For whom a target that is looked for is looked for. */
  public int searcher(int target) {
    return searcher[target];
  }

  public int first() {
    return order.first();
  }

  public int next(int target) {
    return order.next(target);
  }
}
