package org.hificamsim.agents.search;

/**
 * Finds the best configuration of a problem, with proof. Where its limit of search nodes ends the
 * search, the configuration is the best one found so far. Nothing is allocated after construction,
 * and the result depends on the problem alone.
 */
public abstract class Solver {
  /** No limit of search nodes: every result is proven. */
  public static final long UNLIMITED = Long.MAX_VALUE;

  /** Whether the last solution is proven to be the best. */
  protected boolean proven;

  /** By how much another configuration might score higher at most; 0 where that is proven. */
  protected double gap;

  /** Solves the problem as it is filled now. */
  public abstract void solve();

  /** The number of the set that the camera chooses in the last solution. */
  public abstract int chosen(int camera);

  /** Whether the last solution is proven to be the best. */
  public final boolean proven() {
    return proven;
  }

  /** By how much another configuration might score higher at most; 0 where that is proven. */
  public final double gap() {
    return gap;
  }
}
