package org.hificamsim.agents.search;

import java.util.Arrays;

/** One set for each camera, and how many cameras cover each target with these sets. */
final class Choice {
  private final CoverageProblem problem;
  private final int[] chosen;
  private final int[] coverage;

  Choice(CoverageProblem problem) {
    this.problem = problem;
    chosen = new int[problem.maxCameras()];
    coverage = new int[problem.maxTargets()];
  }

  /** No camera has a set. */
  void clear() {
    Arrays.fill(coverage, 0, problem.targets(), 0);
  }

  /** Every camera's most preferred set. */
  void reset() {
    clear();
    for (int camera = 0; camera < problem.cameras(); camera++) {
      give(camera, problem.firstSet(camera));
    }
  }

  /** Every camera's most preferred set among those that remain. */
  void copy(Remaining remaining) {
    clear();
    for (int camera = 0; camera < problem.cameras(); camera++) {
      give(camera, remaining.first(camera));
    }
  }

  /** The same sets as another choice. */
  void copy(Choice other) {
    System.arraycopy(other.chosen, 0, chosen, 0, problem.cameras());
    System.arraycopy(other.coverage, 0, coverage, 0, problem.targets());
  }

  /** The same sets as another choice where they remain, else the camera's first that remains. */
  void adapt(Choice other, Remaining remaining) {
    copy(other);
    for (int i = 0; i < remaining.openCameras(); i++) {
      int camera = remaining.openCamera(i);
      if (!remaining.has(chosen[camera])) {
        take(camera);
        give(camera, remaining.first(camera));
      }
    }
  }

  /** Leaves the camera without a set; {@link #of} still returns the one it had. */
  void take(int camera) {
    count(chosen[camera], -1);
  }

  /** Gives a camera without a set one. */
  void give(int camera, int set) {
    chosen[camera] = set;
    count(set, 1);
  }

  /** Gives the camera another set. */
  void exchange(int camera, int set) {
    for (int word = 0; word < problem.words(); word++) {
      long before = problem.mask(chosen[camera], word);
      long after = problem.mask(set, word);
      CoverageProblem.add(coverage, word, before & ~after, -1);
      CoverageProblem.add(coverage, word, after & ~before, 1);
    }
    chosen[camera] = set;
  }

  /**
   * Gives the camera another set unless the coverage of some target fell below {@code least}. Every
   * target is covered by so many before.
   */
  boolean replace(int camera, int set, int least) {
    if (coversTooLittle(camera, set, least)) {
      return false;
    }
    exchange(camera, set);
    return true;
  }

  private boolean coversTooLittle(int camera, int set, int least) {
    for (int word = 0; word < problem.words(); word++) {
      long lost = problem.mask(chosen[camera], word) & ~problem.mask(set, word);
      for (long bits = lost; bits != 0; bits &= bits - 1) {
        if (coverage[(word << 6) + Long.numberOfTrailingZeros(bits)] <= least) {
          return true;
        }
      }
    }
    return false;
  }

  int of(int camera) {
    return chosen[camera];
  }

  int coverage(int target) {
    return coverage[target];
  }

  /** k_min: the coverage of the least covered target; all cameras when there is no target. */
  int least() {
    int least = problem.cameras();
    for (int target = 0; target < problem.targets(); target++) {
      least = Math.min(least, coverage[target]);
    }
    return least;
  }

  /** What the targets are worth together. */
  long value(Worth worth) {
    long value = 0;
    for (int target = 0; target < problem.targets(); target++) {
      value += worth.of(coverage[target]);
    }
    return value;
  }

  private void count(int set, int change) {
    for (int word = 0; word < problem.words(); word++) {
      CoverageProblem.add(coverage, word, problem.mask(set, word), change);
    }
  }
}
