package org.hificamsim.agents.search;

/** One set for each camera, and how many cameras thereby cover each target. */
final class Choice {
  private final CoverageProblem problem;
  private final int[] chosen;
  private final int[] coverage;

  Choice(CoverageProblem problem) {
    this.problem = problem;
    chosen = new int[problem.mostCameras()];
    coverage = new int[problem.mostTargets()];
  }

  /** Every camera's most preferred set. */
  void preferred() {
    clear();
    for (int camera = 0; camera < problem.cameras(); camera++) {
      chosen[camera] = problem.firstSet(camera);
      count(chosen[camera], 1);
    }
  }

  /** Every camera's most preferred set among those that remain. */
  void copy(Domains domains) {
    clear();
    for (int camera = 0; camera < problem.cameras(); camera++) {
      chosen[camera] = domains.firstAlive(camera);
      count(chosen[camera], 1);
    }
  }

  /** Gives the camera another set unless the coverage of some target fell below {@code least}. */
  boolean replace(int camera, int set, int least) {
    int before = chosen[camera];
    count(before, -1);
    count(set, 1);
    if (least() >= least) {
      chosen[camera] = set;
      return true;
    }
    count(set, -1);
    count(before, 1);
    return false;
  }

  int of(int camera) {
    return chosen[camera];
  }

  /** k_min: the coverage of the least covered target. */
  int least() {
    int least = problem.cameras();
    for (int target = 0; target < problem.targets(); target++) {
      least = Math.min(least, coverage[target]);
    }
    return least;
  }

  private void clear() {
    for (int target = 0; target < problem.targets(); target++) {
      coverage[target] = 0;
    }
  }

  private void count(int set, int change) {
    for (int word = 0; word < problem.words(); word++) {
      for (long bits = problem.mask(set, word); bits != 0; bits &= bits - 1) {
        coverage[(word << 6) + Long.numberOfTrailingZeros(bits)] += change;
      }
    }
  }
}
