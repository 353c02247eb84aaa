package org.hificamsim.solver;

/**
 * Depth-first branch and bound: at each node of a {@link Tree} a decision is taken, and refused
 * once everything that follows from it has been searched.
 */
public final class BranchAndBound {
  /** The tree to search. It chooses and bounds decisions, and keeps the best result found. */
  public interface Tree {
    /** No decision: nothing better than the best result so far follows from here. */
    int NONE = -1;

    /** Evaluates the current node; returns the next decision to take, or {@link #NONE}. */
    int branch();

    /** Takes a decision. */
    void take(int decision);

    /** Undoes the last decision and everything after it; it will not be taken again. */
    void refuse(int decision);

    /** Whether the search can end, because the result is good enough. */
    default boolean isDone() {
      return false;
    }
  }

  private long nodes;
  private long lastNode;

  /** Sets the number of nodes back to 0. */
  public void reset() {
    nodes = 0;
  }

  /** The number of decisions taken since {@link #reset}. */
  public long nodes() {
    return nodes;
  }

  /**
   * Searches the tree.
   *
   * @param maxNodes the number of decisions after which the search is given up
   * @return whether the search was not given up
   */
  public boolean search(Tree tree, long maxNodes) {
    lastNode = maxNodes > Long.MAX_VALUE - nodes ? Long.MAX_VALUE : nodes + maxNodes;
    return search(tree);
  }

  private boolean search(Tree tree) {
    for (int next = tree.branch(); next != Tree.NONE; next = tree.branch()) {
      if (nodes >= lastNode) {
        return false;
      }
      nodes++;
      tree.take(next);
      if (!search(tree)) {
        return false;
      }
      if (tree.isDone()) {
        return true;
      }
      tree.refuse(next);
    }
    return true;
  }
}
