package org.hificamsim.agents.search;

/**
 * How many cameras can still cover each target, and how many must.
 *
 * <p>A target's <em>supply</em> is the number of cameras with some remaining set that holds it, its
 * <em>sure</em> coverage the number of cameras all of whose remaining sets do.
 */
final class Supply {
  private final CoverageProblem problem;
  private final Remaining remaining;
  private final long[] any;
  private final long[] all;
  private final int[] supply;
  private final int[] sure;
  private final int[] tight;
  private int tightTargets;
  private int words;
  private int k;

  Supply(CoverageProblem problem, Remaining remaining) {
    this.problem = problem;
    this.remaining = remaining;
    int targets = problem.maxTargets();
    any = new long[problem.maxCameras() * CoverageProblem.wordsFor(targets)];
    all = new long[any.length];
    supply = new int[targets];
    sure = new int[targets];
    tight = new int[targets];
  }

  /** Counts again, with every set of every camera remaining. */
  void reset() {
    words = problem.words();
    k = 0;
    for (int target = 0; target < problem.targets(); target++) {
      supply[target] = 0;
      sure[target] = 0;
    }
    for (int camera = 0; camera < problem.cameras(); camera++) {
      for (int word = 0; word < words; word++) {
        join(camera, word);
        CoverageProblem.add(supply, word, any[camera * words + word], 1);
        CoverageProblem.add(sure, word, all[camera * words + word], 1);
      }
    }
  }

  /** The least supply of any target; all cameras when there is none. */
  int least() {
    int least = problem.cameras();
    for (int target = 0; target < problem.targets(); target++) {
      least = Math.min(least, supply[target]);
    }
    return least;
  }

  /** Demands coverage k of every target; the targets whose supply is just k become tight. */
  void require(int coverage) {
    k = coverage;
    tightTargets = 0;
    for (int target = 0; target < problem.targets(); target++) {
      if (supply[target] == k) {
        tight[tightTargets++] = target;
      }
    }
  }

  /** Forgets which targets became tight. */
  void clearTight() {
    tightTargets = 0;
  }

  /** Whether {@link #nextTight} has a target left. */
  boolean hasTight() {
    return tightTargets > 0;
  }

  /** A target whose supply has come down to just k, each only once; -1 when there is none. */
  int nextTight() {
    return tightTargets == 0 ? -1 : tight[--tightTargets];
  }

  /**
   * Updates the counts after a removal that left its camera another set.
   *
   * @return whether every target still has a supply of k or more
   */
  boolean removed(int set) {
    int camera = problem.cameraOf(set);
    boolean enough = true;
    for (int word = 0; word < words; word++) {
      int at = camera * words + word;
      long anyBefore = any[at];
      long allBefore = all[at];
      join(camera, word);
      CoverageProblem.add(sure, word, all[at] & ~allBefore, 1);
      enough &= lose(word, anyBefore & ~any[at]);
    }
    return enough;
  }

  /** Updates the counts after a removal was undone. */
  void restored(int set) {
    int camera = problem.cameraOf(set);
    for (int word = 0; word < words; word++) {
      int at = camera * words + word;
      long mask = problem.mask(set, word);
      CoverageProblem.add(supply, word, mask & ~any[at], 1);
      CoverageProblem.add(sure, word, all[at] & ~mask, -1);
      any[at] |= mask;
      all[at] &= mask;
    }
  }

  /** The targets on which the camera's remaining sets differ, one word of the mask. */
  long undecided(int camera, int word) {
    return any[camera * words + word] & ~all[camera * words + word];
  }

  /** Whether the camera's remaining sets differ on the target. */
  boolean undecidedOn(int camera, int target) {
    return (undecided(camera, target >> 6) >>> target & 1) != 0;
  }

  /** How many more cameras could cover the target than must. */
  int slack(int target) {
    return supply[target] - k;
  }

  /** How many cameras the target still lacks; 0 or less when it is satisfied. */
  int lack(int target) {
    return k - sure[target];
  }

  private void join(int camera, int word) {
    long union = 0;
    long intersection = -1;
    for (int set = problem.firstSet(camera); set < problem.endSet(camera); set++) {
      if (remaining.has(set)) {
        union |= problem.mask(set, word);
        intersection &= problem.mask(set, word);
      }
    }
    any[camera * words + word] = union;
    all[camera * words + word] = intersection;
  }

  private boolean lose(int word, long targets) {
    boolean enough = true;
    for (long bits = targets; bits != 0; bits &= bits - 1) {
      int target = (word << 6) + Long.numberOfTrailingZeros(bits);
      int left = --supply[target];
      if (left == k) {
        tight[tightTargets++] = target;
      }
      enough &= left >= k;
    }
    return enough;
  }
}
