package org.hificamsim.agents.search;

/** The sets that each camera may still choose; removals are undone in reverse order. */
final class Remaining {
  private final CoverageProblem problem;
  private final boolean[] remains;
  private final int[] counts;
  private final int[] open;
  private final int[] removed;
  private int openCameras;
  private int removals;

  Remaining(CoverageProblem problem) {
    this.problem = problem;
    remains = new boolean[problem.maxSets()];
    counts = new int[problem.maxCameras()];
    open = new int[problem.maxCameras()];
    removed = new int[problem.maxSets()];
  }

  /** Every set of every camera remains. */
  void reset() {
    openCameras = 0;
    removals = 0;
    for (int camera = 0; camera < problem.cameras(); camera++) {
      counts[camera] = problem.endSet(camera) - problem.firstSet(camera);
      if (counts[camera] > 1) {
        open[openCameras++] = camera;
      }
    }
    for (int set = 0; set < problem.sets(); set++) {
      remains[set] = true;
    }
  }

  boolean has(int set) {
    return remains[set];
  }

  /** The number of sets that remain to the camera. */
  int count(int camera) {
    return counts[camera];
  }

  /** The camera's most preferred remaining set. */
  int first(int camera) {
    int set = problem.firstSet(camera);
    while (!remains[set]) {
      set++;
    }
    return set;
  }

  /** Removes a set that remains; returns how many remain to its camera. */
  int remove(int set) {
    remains[set] = false;
    removed[removals++] = set;
    return --counts[problem.cameraOf(set)];
  }

  /** The number of removals not undone. */
  int removals() {
    return removals;
  }

  /** Undoes the last removal and returns its set. */
  int restore() {
    int set = removed[--removals];
    remains[set] = true;
    counts[problem.cameraOf(set)]++;
    return set;
  }

  /** The number of cameras that had a choice at {@link #reset}. */
  int openCameras() {
    return openCameras;
  }

  /** The i-th camera that had a choice at {@link #reset}, in order of number. */
  int openCamera(int i) {
    return open[i];
  }
}
