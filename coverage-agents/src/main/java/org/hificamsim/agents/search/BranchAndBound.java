package org.hificamsim.agents.search;

/**
 * Depth-first branch and bound: at each node of a {@link Tree} a decision is taken, and refused
 * when everything that follows from it has been searched.
 */
public final class BranchAndBound {
  /** What is searched. It says what is worth searching, and keeps the best that it meets. */
  public interface Tree {
    /** No decision: nothing that is better than what has been met follows from here. */
    int NONE = -1;

    /**
     * Looks at where the search has come to; returns the next decision to take, or {@link #NONE}.
     */
    int branch();

    /** Takes a decision. */
    void take(int decision);

    /** Takes back the last decision and all that it led to; it is not taken again. */
    void refuse(int decision);

    /** Whether what has been met is enough. */
    default boolean isDone() {
      return false;
    }
  }

  private long nodes;
  private long lastNode;

  /** Counts nodes from 0 again. */
  public void reset() {
    nodes = 0;
  }

  /** The number of decisions taken. */
  public long nodes() {
    return nodes;
  }

  /**
   * Searches the tree.
   *
   * @param maxNodes number of decisions after which the search is given up
   * @return whether all was searched, or enough was met
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
