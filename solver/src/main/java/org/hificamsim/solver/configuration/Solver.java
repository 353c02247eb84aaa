package org.hificamsim.solver.configuration;

/**
 * Finds the best configuration of a coverage problem, and proves it. When the limit of search nodes
 * ends the search, the configuration is the best one found so far. The result depends on the
 * problem alone.
 */
public abstract class Solver {
  /** No limit of search nodes: every result is proven. */
  public static final long UNLIMITED = Long.MAX_VALUE;

  /** Whether the last solution is proven to be the best. */
  protected boolean proven;

  /** The most by which another configuration could score higher; 0 if the solution is proven. */
  protected double gap;

  /** Solves the problem as it is filled now. */
  public abstract void solve();

  /** The number of the set that the camera chooses in the last solution. */
  public abstract int chosen(int camera);

  /** Whether the last solution is proven to be the best. */
  public final boolean proven() {
    return proven;
  }

  /** The most by which another configuration could score higher; 0 if the solution is proven. */
  public final double gap() {
    return gap;
  }
}
