package org.hificamsim.agents.search;

import java.util.Arrays;

/**
 * The cameras whose set is decided and those still open, how often the decided ones cover each
 * target, and how many open ones can; decisions are undone in reverse order.
 */
final class Decisions {
  private final CoverageProblem problem;
  private final int[] chosen;
  private final int[] order; // open cameras first
  private final int[] place;
  private final long[] any;
  private final int[] k;
  private final int[] supply;
  private final boolean[] lesser;
  private int open;

  Decisions(CoverageProblem problem) {
    this.problem = problem;
    chosen = new int[problem.maxCameras()];
    order = new int[problem.maxCameras()];
    place = new int[problem.maxCameras()];
    any = new long[problem.maxCameras() * CoverageProblem.wordsFor(problem.maxTargets())];
    k = new int[problem.maxTargets()];
    supply = new int[problem.maxTargets()];
    lesser = new boolean[problem.maxSets()];
  }

  /** Every camera is open. */
  void reset() {
    Arrays.fill(k, 0, problem.targets(), 0);
    Arrays.fill(supply, 0, problem.targets(), 0);
    open = problem.cameras();
    for (int camera = 0; camera < open; camera++) {
      order[camera] = camera;
      place[camera] = camera;
      join(camera);
      findLesser(camera);
    }
  }

  private void join(int camera) {
    for (int word = 0; word < problem.words(); word++) {
      long union = 0;
      for (int set = problem.firstSet(camera); set < problem.endSet(camera); set++) {
        union |= problem.mask(set, word);
      }
      any[camera * problem.words() + word] = union;
      CoverageProblem.add(supply, word, union, 1);
    }
  }

  /** Marks the sets that another one includes; of equal ones the first is not marked. */
  private void findLesser(int camera) {
    for (int set = problem.firstSet(camera); set < problem.endSet(camera); set++) {
      lesser[set] = false;
      for (int other = problem.firstSet(camera); other < problem.endSet(camera); other++) {
        lesser[set] |=
            other != set
                && problem.holds(other, set)
                && (other < set || !problem.holds(set, other));
      }
    }
  }

  /** Whether another set of the camera has all that this one has. */
  boolean isLesser(int set) {
    return lesser[set];
  }

  void decide(int camera, int set) {
    int last = order[--open];
    int at = place[camera];
    order[at] = last;
    place[last] = at;
    order[open] = camera;
    place[camera] = open;
    chosen[camera] = set;
    count(camera, 1);
  }

  /** Takes back the last decision; returns its camera. */
  int undo() {
    int camera = order[open++];
    count(camera, -1);
    return camera;
  }

  private void count(int camera, int change) {
    for (int word = 0; word < problem.words(); word++) {
      CoverageProblem.add(k, word, problem.mask(chosen[camera], word), change);
      CoverageProblem.add(supply, word, any(camera, word), -change);
    }
  }

  /** The number of open cameras. */
  int open() {
    return open;
  }

  /** One of the open cameras, in no order that means anything. */
  int openCamera(int i) {
    return order[i];
  }

  /** The set of a camera that is decided. */
  int chosen(int camera) {
    return chosen[camera];
  }

  /** The targets that some set of the camera holds, one word of the mask. */
  long any(int camera, int word) {
    return any[camera * problem.words() + word];
  }

  /** How many decided cameras cover the target. */
  int k(int target) {
    return k[target];
  }

  /** How many open cameras can cover the target. */
  int supply(int target) {
    return supply[target];
  }
}
