package org.hificamsim.agents.search;

import java.util.Arrays;

/** One set for each camera, and how many cameras cover each target with these sets. */
final class Configuration {
  private final CoverageProblem problem;
  private final int[] chosen;
  private final int[] coverage;

  Configuration(CoverageProblem problem) {
    this.problem = problem;
    chosen = new int[problem.maxCameras()];
    coverage = new int[problem.maxTargets()];
  }

  /** Every camera's most preferred set. */
  void reset() {
    clear();
    for (int camera = 0; camera < problem.cameras(); camera++) {
      give(camera, problem.firstSet(camera));
    }
  }

  /** The same sets as another configuration. */
  void copy(Configuration other) {
    System.arraycopy(other.chosen, 0, chosen, 0, problem.cameras());
    System.arraycopy(other.coverage, 0, coverage, 0, problem.targets());
  }

  /** The same sets as another one where they remain, else the camera's first that remains. */
  void copy(Configuration other, RemainingSets remaining) {
    copy(other);
    for (int camera = 0; camera < problem.cameras(); camera++) {
      if (!remaining.has(chosen[camera])) {
        exchange(camera, remaining.first(camera));
      }
    }
  }

  /** No camera has a set. */
  void clear() {
    Arrays.fill(coverage, 0, problem.targets(), 0);
  }

  /** Gives a camera without a set one. */
  void give(int camera, int set) {
    chosen[camera] = set;
    count(set, 1);
  }

  /** Leaves the camera without a set; {@link #of} still returns the one it had. */
  void take(int camera) {
    count(chosen[camera], -1);
  }

  private void count(int set, int change) {
    for (int word = 0; word < problem.words(); word++) {
      CoverageProblem.add(coverage, word, problem.mask(set, word), change);
    }
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

  /** The set of a camera. */
  int of(int camera) {
    return chosen[camera];
  }

  /** How many cameras cover each target. */
  int[] coverage() {
    return coverage;
  }
}
