package org.hificamsim.agents.search;

import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * The sets that each camera may still choose, and what follows from them for targets: how many
 * cameras can cover a target at most (its <em>supply</em>: cameras with some remaining set that
 * holds it), and how many do in any case (its <em>sure</em> coverage: cameras all of whose
 * remaining sets hold it). Removals are undone in reverse order.
 */
final class RemainingSets {
  private final CoverageProblem problem;
  private final boolean[] remains;
  private final boolean[] included;
  private final int[] counts;
  private final int[] removed;
  private final int[] choosing;
  private final long[] any;
  private final long[] all;
  private final int[] supply;
  private final int[] sure;
  private boolean includedIsKnown;
  private int withChoice;
  private int removals;

  RemainingSets(CoverageProblem problem) {
    this.problem = problem;
    remains = new boolean[problem.maxSets()];
    included = new boolean[problem.maxSets()];
    counts = new int[problem.maxCameras()];
    removed = new int[problem.maxSets()];
    choosing = new int[problem.maxCameras()];
    any = new long[problem.maxCameras() * CoverageProblem.wordsFor(problem.maxTargets())];
    all = new long[any.length];
    supply = new int[problem.maxTargets()];
    sure = new int[problem.maxTargets()];
  }

  /** Every set of every camera remains. */
  void reset() {
    includedIsKnown = false;
    withChoice = 0;
    removals = 0;
    Arrays.fill(remains, 0, problem.sets(), true);
    Arrays.fill(supply, 0, problem.targets(), 0);
    Arrays.fill(sure, 0, problem.targets(), 0);
    for (int camera = 0; camera < problem.cameras(); camera++) {
      counts[camera] = problem.endSet(camera) - problem.firstSet(camera);
      choosing[withChoice] = camera;
      withChoice += counts[camera] > 1 ? 1 : 0;
      for (int word = 0; word < problem.words(); word++) {
        join(camera, word);
        CoverageProblem.add(supply, word, any(camera, word), 1);
        CoverageProblem.add(sure, word, all[at(camera, word)], 1);
      }
    }
  }

  private int at(int camera, int word) {
    return camera * problem.words() + word;
  }

  private void join(int camera, int word) {
    long union = 0;
    long intersection = -1;
    for (int set = problem.firstSet(camera); set < problem.endSet(camera); set++) {
      if (remains[set]) {
        union |= problem.mask(set, word);
        intersection &= problem.mask(set, word);
      }
    }
    any[at(camera, word)] = union;
    all[at(camera, word)] = intersection;
  }

  /** Removes the sets of open cameras that another one includes; of equal ones the first stays. */
  void dropIncluded() {
    if (!includedIsKnown) {
      findIncluded();
    }
    for (int set = 0; set < problem.sets(); set++) {
      if (included[set] && remains[set] && isOpen(problem.cameraOf(set))) {
        remove(set);
      }
    }
  }

  private void findIncluded() {
    includedIsKnown = true;
    for (int set = 0; set < problem.sets(); set++) {
      int camera = problem.cameraOf(set);
      included[set] = false;
      for (int other = problem.firstSet(camera); other < problem.endSet(camera); other++) {
        included[set] |=
            other != set
                && problem.holds(other, set)
                && (other < set || !problem.holds(set, other));
      }
    }
  }

  /** Removes a set that remains; false where its camera has no other. */
  boolean remove(int set) {
    int camera = problem.cameraOf(set);
    remains[set] = false;
    removed[removals++] = set;
    if (--counts[camera] == 0) {
      return false;
    }
    for (int word = 0; word < problem.words(); word++) {
      long anyBefore = any(camera, word);
      long allBefore = all[at(camera, word)];
      join(camera, word);
      CoverageProblem.add(supply, word, anyBefore & ~any(camera, word), -1);
      CoverageProblem.add(sure, word, all[at(camera, word)] & ~allBefore, 1);
    }
    return true;
  }

  /** Leaves its camera this set alone, which remains. */
  void choose(int set) {
    int camera = problem.cameraOf(set);
    for (int other = problem.firstSet(camera); other < problem.endSet(camera); other++) {
      if (other != set && remains[other]) {
        remains[other] = false;
        removed[removals++] = other;
      }
    }
    counts[camera] = 1;
    for (int word = 0; word < problem.words(); word++) {
      long mask = problem.mask(set, word);
      CoverageProblem.add(supply, word, any(camera, word) & ~mask, -1);
      CoverageProblem.add(sure, word, mask & ~all[at(camera, word)], 1);
      any[at(camera, word)] = mask;
      all[at(camera, word)] = mask;
    }
  }

  /** The number of removals so far: what {@link #undo} goes back to. */
  int mark() {
    return removals;
  }

  /** Takes back all removals after {@code mark}. */
  void undo(int mark) {
    while (removals > mark) {
      restore(removed[--removals]);
    }
  }

  private void restore(int set) {
    int camera = problem.cameraOf(set);
    remains[set] = true;
    if (counts[camera]++ > 0) {
      for (int word = 0; word < problem.words(); word++) {
        long mask = problem.mask(set, word);
        CoverageProblem.add(supply, word, mask & ~any(camera, word), 1);
        CoverageProblem.add(sure, word, all[at(camera, word)] & ~mask, -1);
        any[at(camera, word)] |= mask;
        all[at(camera, word)] &= mask;
      }
    }
  }

  boolean has(int set) {
    return remains[set];
  }

  /** The camera's most preferred remaining set. */
  int first(int camera) {
    int set = problem.firstSet(camera);
    while (!remains[set]) {
      set++;
    }
    return set;
  }

  /** The sets that remain to the camera. */
  int[] sets(int camera) {
    return IntStream.range(problem.firstSet(camera), problem.endSet(camera))
        .filter(set -> remains[set])
        .toArray();
  }

  /** Whether the camera has more than one set. */
  boolean isOpen(int camera) {
    return counts[camera] > 1;
  }

  /** The number of sets that remain to the camera. */
  int count(int camera) {
    return counts[camera];
  }

  /** The number of cameras that had a choice at {@link #reset}. */
  int withChoice() {
    return withChoice;
  }

  /** The i-th camera that had a choice at {@link #reset}, in order of number. */
  int withChoice(int i) {
    return choosing[i];
  }

  /** How many cameras can cover the target. */
  int supply(int target) {
    return supply[target];
  }

  /** By camera: the same numbers, not to be changed. */
  int[] supply() {
    return supply;
  }

  /** How many cameras cover the target whatever they choose. */
  int sure(int target) {
    return sure[target];
  }

  /** The targets that some remaining set of the camera holds, one word of the mask. */
  long any(int camera, int word) {
    return any[at(camera, word)];
  }

  /** The targets on which the camera's remaining sets differ, one word of the mask. */
  long undecided(int camera, int word) {
    return any[at(camera, word)] & ~all[at(camera, word)];
  }

  /** Whether the camera's remaining sets differ on the target. */
  boolean undecidedOn(int camera, int target) {
    return (undecided(camera, target >> 6) >>> target & 1) != 0;
  }
}
