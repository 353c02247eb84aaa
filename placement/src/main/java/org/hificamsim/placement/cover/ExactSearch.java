package org.hificamsim.placement.cover;

import java.util.function.BooleanSupplier;

/** Solves a covering problem to a proven end, if it is given the time. */
public interface ExactSearch {
  /**
   * What was found.
   *
   * @param chosen candidates
   * @param bound on the score of any plan
   */
  record Found(int[] chosen, double bound) {}

  /**
   * Searches.
   *
   * @param hint candidates to begin with
   * @param stop ends the search
   */
  Found search(CoverInstance instance, Goal goal, int[] hint, BooleanSupplier stop);
}
