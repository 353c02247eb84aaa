package org.hificamsim.agents.search;

/**
 * The choice among cameras each of which has a whole set: one that holds all that its others do, as
 * where views are discs. Nothing is lost by it, so all cameras' whole sets reach the best coverage,
 * and a camera may have a set that it prefers just where the whole sets of those that are still to
 * be asked keep that coverage up. Nothing has to be searched.
 */
final class WholeSets {
  private static final int NONE = -1;

  private final CoverageProblem problem;

  WholeSets(CoverageProblem problem) {
    this.problem = problem;
  }

  /** Gives every camera a whole set; false when one has none, and some may have got theirs. */
  boolean give(Choice choice) {
    choice.clear();
    for (int camera = 0; camera < problem.cameras(); camera++) {
      int whole = find(camera);
      if (whole == NONE) {
        return false;
      }
      choice.give(camera, whole);
    }
    return true;
  }

  /** Whichever set of the camera holds all others held the one before it when it was met. */
  private int find(int camera) {
    int whole = problem.firstSet(camera);
    for (int set = whole + 1; set < problem.endSet(camera); set++) {
      whole = problem.holds(set, whole) ? set : whole;
    }
    for (int set = problem.firstSet(camera); set < problem.endSet(camera); set++) {
      if (!problem.holds(whole, set)) {
        return NONE;
      }
    }
    return whole;
  }

  /** Lets camera 0 have its most preferred set with which coverage k stays, then camera 1, ... */
  void prefer(int k, Choice choice) {
    for (int camera = 0; camera < problem.cameras(); camera++) {
      int set = problem.firstSet(camera);
      while (set != choice.of(camera) && !choice.replace(camera, set, k)) {
        set++;
      }
    }
  }
}
