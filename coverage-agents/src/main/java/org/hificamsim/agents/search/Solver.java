package org.hificamsim.agents.search;

import org.hificamsim.core.metrics.Objective;

/**
 * Finds the best choice of a {@link CoverageProblem} by an objective, with proof. Where its limit
 * of search nodes ends the search, the choice is the best one found so far. Nothing is allocated
 * after construction, and the result depends on the problem alone.
 */
public interface Solver {
  /**
   * The solver for an objective.
   *
   * @param problem what each call of {@link #solve} reads
   * @param maxNodes number of search nodes after which a call gives up the proof
   */
  static Solver of(Objective objective, CoverageProblem problem, long maxNodes) {
    return objective.isKMin()
        ? new CoverageSolver(problem, maxNodes)
        : new ValueSolver(objective, problem, maxNodes);
  }

  /** Solves the problem as it is filled now. */
  void solve();

  /** The number of the set that the camera chooses in the last solution. */
  int chosen(int camera);

  /** Whether the last solution is proven to be the best. */
  boolean proven();

  /** By how much another choice might score higher at most; 0 where that is proven. */
  double gap();
}
