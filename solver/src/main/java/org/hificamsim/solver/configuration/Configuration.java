package org.hificamsim.solver.configuration;

import java.util.Arrays;
import org.hificamsim.solver.BitMatrix;

/** One set for each camera, and how many cameras cover each target with these sets. */
final class Configuration {
  private final CoverageProblem problem;
  private final int[] sets;
  private final int[] coverage;

  Configuration(CoverageProblem problem) {
    this.problem = problem;
    sets = new int[problem.maxCameras()];
    coverage = new int[problem.maxTargets()];
  }

  /** Gives every camera its most preferred set. */
  void reset() {
    clear();
    for (int camera = 0; camera < problem.cameras(); camera++) {
      assign(camera, problem.firstSet(camera));
    }
  }

  /** Copies the sets of another configuration. */
  void copy(Configuration other) {
    System.arraycopy(other.sets, 0, sets, 0, problem.cameras());
    System.arraycopy(other.coverage, 0, coverage, 0, problem.targets());
  }

  /**
   * Copies the sets of another configuration; a camera whose set does not remain gets its first
   * remaining one.
   */
  void copy(Configuration other, RemainingSets remaining) {
    copy(other);
    for (int camera = 0; camera < problem.cameras(); camera++) {
      if (!remaining.has(sets[camera])) {
        exchange(camera, remaining.first(camera));
      }
    }
  }

  /** Leaves all cameras without a set. */
  void clear() {
    Arrays.fill(coverage, 0, problem.targets(), 0);
  }

  /** Gives a camera that has no set this one. */
  void assign(int camera, int set) {
    sets[camera] = set;
    count(set, 1);
  }

  /** Leaves the camera without a set; {@link #set} still returns the one that it had. */
  void unassign(int camera) {
    count(sets[camera], -1);
  }

  private void count(int set, int change) {
    problem.masks().add(set, coverage, change);
  }

  /** Replaces the camera's set. */
  void exchange(int camera, int set) {
    for (int word = 0; word < problem.words(); word++) {
      long before = problem.mask(sets[camera], word);
      long after = problem.mask(set, word);
      BitMatrix.add(coverage, word, before & ~after, -1);
      BitMatrix.add(coverage, word, after & ~before, 1);
    }
    sets[camera] = set;
  }

  /** The set of a camera. */
  int set(int camera) {
    return sets[camera];
  }

  /** The number of cameras that cover each target; not to be changed. */
  int[] coverage() {
    return coverage;
  }
}
