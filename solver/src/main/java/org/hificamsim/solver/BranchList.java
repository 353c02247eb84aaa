package org.hificamsim.solver;

import java.util.Arrays;

/**
 * A tree for {@link BranchAndBound} whose nodes list their branches when they are first visited.
 * The problem says which branches a node has and what taking one changes; this class keeps the
 * path, and which branches of each node on it are left.
 */
public final class BranchList implements BranchAndBound.Tree {
  /** The problem that is searched. A branch is a number of the problem's own. */
  public interface Problem {
    /**
     * Bounds a node that is visited for the first time, and {@linkplain BranchList#add adds} its
     * branches; without any, nothing better follows from the node.
     *
     * @param depth the number of branches that were taken to get to the node
     */
    void list(int depth);

    /** Takes a branch of the node. */
    void take(int depth, int branch);

    /** Undoes the branch that the node took. */
    void undo(int depth, int branch);

    /** Whether a listed branch may still lead to a better result; if not, the node is left. */
    default boolean isPromising(int depth, int branch) {
      return true;
    }

    /** Whether the search is to end. */
    default boolean isDone() {
      return false;
    }
  }

  private static final int UNLISTED = -1;
  private static final int LEAST_LENGTH = 8;

  private final Problem problem;

  /** The branches of each node on the path, those to be taken first in front, by depth. */
  private final int[][] branches;

  /** The value of a branch, by depth and place in the list. */
  private final double[][] values;

  private final int[] counts;
  private final int[] next;
  private int depth;

  /**
   * @param maxDepth the greatest number of branches on a path
   */
  public BranchList(Problem problem, int maxDepth) {
    this.problem = problem;
    branches = new int[maxDepth + 1][0];
    values = new double[maxDepth + 1][0];
    counts = new int[maxDepth + 1];
    next = new int[maxDepth + 1];
  }

  /** Begins at the root. */
  public void begin() {
    depth = 0;
    counts[0] = UNLISTED;
  }

  /** Adds a branch behind those of the node that is listed. */
  public void add(int branch) {
    int at = counts[depth]++;
    if (at == branches[depth].length) {
      branches[depth] = Arrays.copyOf(branches[depth], grown(at));
    }
    branches[depth][at] = branch;
  }

  /** Lists keep their length, so that only the first nodes of a search make them longer. */
  private static int grown(int length) {
    return Math.max(LEAST_LENGTH, 2 * length);
  }

  /**
   * Adds a branch to the node that is listed, in front of those with a lower value.
   *
   * <p>All branches before it must have been added with a value.
   */
  public void add(int branch, double value) {
    int at = counts[depth];
    add(branch);
    if (at == values[depth].length) {
      values[depth] = Arrays.copyOf(values[depth], grown(at));
    }
    for (; at > 0 && values[depth][at - 1] < value; at--) {
      branches[depth][at] = branches[depth][at - 1];
      values[depth][at] = values[depth][at - 1];
    }
    branches[depth][at] = branch;
    values[depth][at] = value;
  }

  /** The branch that the path takes at a node on it. */
  public int taken(int nodeDepth) {
    return branches[nodeDepth][next[nodeDepth]];
  }

  /** The value of {@link #taken}. */
  public double value(int nodeDepth) {
    return values[nodeDepth][next[nodeDepth]];
  }

  @Override
  public int branch() {
    if (counts[depth] == UNLISTED) {
      counts[depth] = 0;
      next[depth] = 0;
      problem.list(depth);
    }
    boolean left = next[depth] < counts[depth];
    return left && problem.isPromising(depth, taken(depth)) ? taken(depth) : NONE;
  }

  @Override
  public void take(int branch) {
    problem.take(depth, branch);
    depth++;
    counts[depth] = UNLISTED;
  }

  @Override
  public void refuse(int branch) {
    depth--;
    problem.undo(depth, branch);
    next[depth]++;
  }

  @Override
  public boolean isDone() {
    return problem.isDone();
  }
}
