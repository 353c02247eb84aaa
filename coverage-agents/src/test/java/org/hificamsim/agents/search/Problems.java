package org.hificamsim.agents.search;

import java.util.SplittableRandom;

/** Random coverage problems for tests, by camera, set and target. */
final class Problems {
  private Problems() {}

  /** Up to {@code most} sets for each camera, every target in each with that probability. */
  static boolean[][][] random(
      SplittableRandom random, int cameras, int most, int targets, double density) {
    boolean[][][] sets = new boolean[cameras][][];
    for (int camera = 0; camera < cameras; camera++) {
      sets[camera] = new boolean[1 + random.nextInt(most)][targets];
      for (boolean[] set : sets[camera]) {
        for (int target = 0; target < targets; target++) {
          set[target] = random.nextDouble() < density;
        }
      }
    }
    return sets;
  }

  /** Sets by camera, as bit masks of up to 64 targets. */
  static boolean[][][] of(int targets, long[][] masks) {
    boolean[][][] sets = new boolean[masks.length][][];
    for (int camera = 0; camera < masks.length; camera++) {
      sets[camera] = new boolean[masks[camera].length][targets];
      for (int set = 0; set < masks[camera].length; set++) {
        for (int target = 0; target < targets; target++) {
          sets[camera][set][target] = (masks[camera][set] >>> target & 1) != 0;
        }
      }
    }
    return sets;
  }

  static CoverageProblem problem(int targets, boolean[][][] sets) {
    CoverageProblem problem = new CoverageProblem(sets.length, 1_000, targets);
    fill(problem, targets, sets);
    return problem;
  }

  static void fill(CoverageProblem problem, int targets, boolean[][][] sets) {
    problem.clear(targets);
    for (boolean[][] camera : sets) {
      problem.addCamera();
      for (boolean[] set : camera) {
        long[] mask = new long[CoverageProblem.wordsFor(targets)];
        for (int target = 0; target < targets; target++) {
          mask[target / 64] |= set[target] ? 1L << (target % 64) : 0;
        }
        problem.addSet(mask, 0);
      }
    }
  }

  /** Two halves of so many cameras and targets each, without a target in common. */
  static CoverageProblem apart(SplittableRandom random, int cameras, int most, int targets) {
    boolean[][][] half = random(random, cameras, most, targets, 0.4);
    boolean[][][] sets = new boolean[2 * cameras][][];
    for (int camera = 0; camera < 2 * cameras; camera++) {
      boolean[][] of = half[camera % cameras];
      sets[camera] = new boolean[of.length][2 * targets];
      for (int set = 0; set < of.length; set++) {
        int shift = camera < cameras ? 0 : targets;
        System.arraycopy(of[set], 0, sets[camera][set], shift, targets);
      }
    }
    return problem(2 * targets, sets);
  }
}
