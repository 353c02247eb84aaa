package org.hificamsim.solver.configuration;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.hificamsim.solver.BitMatrix;

/**
 * The sets that each camera may still choose, and the range of coverage that follows for each
 * target: from the number of cameras all of whose remaining sets hold it to the number of cameras
 * with any remaining set that holds it. Removals can be undone, the last one first.
 *
 * <p>A choosing camera had more than one set at {@link #reset}, an open camera has more than one
 * now, and a target is undecided for a camera if that depends on which of these the camera chooses.
 */
final class RemainingSets {
  private final CoverageProblem problem;
  private final BitMatrix masks;
  private final boolean[] remains;
  private final boolean[] isIncluded;
  private final int[] setCounts;
  private final int[] removedSets;
  private final int[] choosingCameras;

  /** The targets that any remaining set of a camera holds, by camera. */
  private final BitMatrix unions;

  /** The targets that all remaining sets of a camera hold, by camera. */
  private final BitMatrix intersections;

  private final int[] maxCoverage;
  private final int[] minCoverage;
  private boolean inclusionIsKnown;
  private int choosingCount;
  private int removalCount;

  RemainingSets(CoverageProblem problem) {
    this.problem = problem;
    masks = problem.masks();
    remains = new boolean[problem.maxSets()];
    isIncluded = new boolean[problem.maxSets()];
    setCounts = new int[problem.maxCameras()];
    removedSets = new int[problem.maxSets()];
    choosingCameras = new int[problem.maxCameras()];
    unions = new BitMatrix(problem.maxCameras(), problem.maxTargets());
    intersections = new BitMatrix(problem.maxCameras(), problem.maxTargets());
    maxCoverage = new int[problem.maxTargets()];
    minCoverage = new int[problem.maxTargets()];
  }

  /** Makes every set of every camera remain. */
  void reset() {
    inclusionIsKnown = false;
    choosingCount = 0;
    removalCount = 0;
    unions.reshape(problem.targets());
    intersections.reshape(problem.targets());
    Arrays.fill(remains, 0, problem.sets(), true);
    Arrays.fill(maxCoverage, 0, problem.targets(), 0);
    Arrays.fill(minCoverage, 0, problem.targets(), 0);
    for (int camera = 0; camera < problem.cameras(); camera++) {
      setCounts[camera] = problem.endSet(camera) - problem.firstSet(camera);
      choosingCameras[choosingCount] = camera;
      choosingCount += setCounts[camera] > 1 ? 1 : 0;
      for (int word = 0; word < masks.words(); word++) {
        combineSets(camera, word);
        BitMatrix.add(maxCoverage, word, union(camera, word), 1);
        BitMatrix.add(minCoverage, word, intersections.word(camera, word), 1);
      }
    }
  }

  private void combineSets(int camera, int word) {
    long union = 0;
    long intersection = -1;
    for (int set = problem.firstSet(camera); set < problem.endSet(camera); set++) {
      if (remains[set]) {
        union |= masks.word(set, word);
        intersection &= masks.word(set, word);
      }
    }
    unions.setWord(camera, word, union);
    intersections.setWord(camera, word, intersection);
  }

  /**
   * Removes the sets of open cameras that another set of the camera includes; of equal sets the
   * first one stays.
   */
  void removeIncluded() {
    if (!inclusionIsKnown) {
      findIncluded();
    }
    for (int set = 0; set < problem.sets(); set++) {
      if (isIncluded[set] && remains[set] && isOpen(problem.cameraOf(set))) {
        remove(set);
      }
    }
  }

  private void findIncluded() {
    inclusionIsKnown = true;
    for (int set = 0; set < problem.sets(); set++) {
      int camera = problem.cameraOf(set);
      isIncluded[set] = false;
      for (int other = problem.firstSet(camera); other < problem.endSet(camera); other++) {
        isIncluded[set] |=
            other != set
                && problem.includes(other, set)
                && (other < set || !problem.includes(set, other));
      }
    }
  }

  /** Removes a set that remains; returns whether its camera still has one. */
  boolean remove(int set) {
    int camera = problem.cameraOf(set);
    remains[set] = false;
    removedSets[removalCount++] = set;
    if (--setCounts[camera] == 0) {
      return false;
    }
    for (int word = 0; word < masks.words(); word++) {
      long unionBefore = union(camera, word);
      long intersectionBefore = intersections.word(camera, word);
      combineSets(camera, word);
      BitMatrix.add(maxCoverage, word, unionBefore & ~union(camera, word), -1);
      BitMatrix.add(minCoverage, word, intersections.word(camera, word) & ~intersectionBefore, 1);
    }
    return true;
  }

  /** Removes all other sets of the camera to which a remaining set belongs. */
  void choose(int set) {
    int camera = problem.cameraOf(set);
    for (int other = problem.firstSet(camera); other < problem.endSet(camera); other++) {
      if (other != set && remains[other]) {
        remains[other] = false;
        removedSets[removalCount++] = other;
      }
    }
    setCounts[camera] = 1;
    for (int word = 0; word < masks.words(); word++) {
      long mask = masks.word(set, word);
      BitMatrix.add(maxCoverage, word, union(camera, word) & ~mask, -1);
      BitMatrix.add(minCoverage, word, mask & ~intersections.word(camera, word), 1);
      unions.setWord(camera, word, mask);
      intersections.setWord(camera, word, mask);
    }
  }

  /**
   * Removes the sets of open cameras whose value is below the greatest of their camera by more than
   * {@code surplus}.
   *
   * @param values the values by set
   * @param greatest value of a remaining set, by camera
   * @return whether every camera still has a set
   */
  boolean removeBelow(long[] values, long[] greatest, long surplus) {
    for (int i = 0; i < choosingCount; i++) {
      int camera = choosingCameras[i];
      if (greatest[camera] > surplus && isOpen(camera)) {
        for (int set = problem.firstSet(camera); set < problem.endSet(camera); set++) {
          boolean below = values[set] < greatest[camera] - surplus;
          if (below && remains[set] && !remove(set)) {
            return false;
          }
        }
      }
    }
    return true;
  }

  /** The number of removals so far, for {@link #undo}. */
  int mark() {
    return removalCount;
  }

  /** Undoes all removals since {@link #mark} returned {@code mark}. */
  void undo(int mark) {
    while (removalCount > mark) {
      restore(removedSets[--removalCount]);
    }
  }

  private void restore(int set) {
    int camera = problem.cameraOf(set);
    remains[set] = true;
    if (setCounts[camera]++ > 0) {
      for (int word = 0; word < masks.words(); word++) {
        long mask = masks.word(set, word);
        BitMatrix.add(maxCoverage, word, mask & ~union(camera, word), 1);
        BitMatrix.add(minCoverage, word, intersections.word(camera, word) & ~mask, -1);
        unions.setWord(camera, word, union(camera, word) | mask);
        intersections.setWord(camera, word, intersections.word(camera, word) & mask);
      }
    }
  }

  /** Whether the set remains. */
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

  /** Returns the sets that remain to the camera. */
  int[] sets(int camera) {
    return IntStream.range(problem.firstSet(camera), problem.endSet(camera))
        .filter(set -> remains[set])
        .toArray();
  }

  /** Whether more than one set remains to the camera. */
  boolean isOpen(int camera) {
    return setCounts[camera] > 1;
  }

  /** The number of sets that remain to the camera. */
  int setCount(int camera) {
    return setCounts[camera];
  }

  /** The number of cameras that had more than one set at {@link #reset}. */
  int choosingCameras() {
    return choosingCount;
  }

  /** The i-th camera that had more than one set at {@link #reset}, in order of number. */
  int choosingCamera(int i) {
    return choosingCameras[i];
  }

  /** The number of cameras that can cover the target. */
  int maxCoverage(int target) {
    return maxCoverage[target];
  }

  /** The number of cameras that can cover each target; not to be changed. */
  int[] maxCoverage() {
    return maxCoverage;
  }

  /** The number of cameras that cover the target with any of their sets. */
  int minCoverage(int target) {
    return minCoverage[target];
  }

  /** The targets that any remaining set of the camera holds: one word of the mask. */
  long union(int camera, int word) {
    return unions.word(camera, word);
  }

  /** The targets that some, but not all, remaining sets of the camera hold: a word of the mask. */
  long undecided(int camera, int word) {
    return unions.word(camera, word) & ~intersections.word(camera, word);
  }

  /** Makes the undecided targets of a camera the only row of a matrix. */
  void copyUndecided(int camera, BitMatrix undecided) {
    undecided.reshape(problem.targets());
    undecided.setRow(0, unions, camera);
    undecided.subtract(0, intersections, camera);
  }

  /** Whether some, but not all, remaining sets of the camera hold the target. */
  boolean isUndecided(int camera, int target) {
    return unions.has(camera, target) && !intersections.has(camera, target);
  }
}
