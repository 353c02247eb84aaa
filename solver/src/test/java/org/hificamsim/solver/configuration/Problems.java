package org.hificamsim.solver.configuration;

import java.util.SplittableRandom;
import org.hificamsim.solver.BitMatrix;

/** Coverage problems for tests; {@code sets} say by camera, set and target what a set holds. */
final class Problems {
  private Problems() {}

  /**
   * Draws 1 to {@code maxSets} sets for each camera; a set holds a target with this probability.
   */
  static boolean[][][] random(
      SplittableRandom random, int cameras, int maxSets, int targets, double density) {
    boolean[][][] sets = new boolean[cameras][][];
    for (int camera = 0; camera < cameras; camera++) {
      sets[camera] = new boolean[1 + random.nextInt(maxSets)][targets];
      for (boolean[] set : sets[camera]) {
        for (int target = 0; target < targets; target++) {
          set[target] = random.nextDouble() < density;
        }
      }
    }
    return sets;
  }

  /** Returns the sets that are given as bit masks of up to 64 targets. */
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
        long[] mask = new long[BitMatrix.wordsFor(targets)];
        for (int target = 0; target < targets; target++) {
          mask[target / 64] |= set[target] ? 1L << (target % 64) : 0;
        }
        problem.addSet(mask, 0);
      }
    }
  }

  /** Returns a problem with two halves of cameras, each with its own targets, and equal sets. */
  static CoverageProblem twoHalves(SplittableRandom random, int cameras, int maxSets, int targets) {
    boolean[][][] half = random(random, cameras, maxSets, targets, 0.4);
    boolean[][][] sets = new boolean[2 * cameras][][];
    for (int camera = 0; camera < 2 * cameras; camera++) {
      boolean[][] halfSets = half[camera % cameras];
      sets[camera] = new boolean[halfSets.length][2 * targets];
      for (int set = 0; set < halfSets.length; set++) {
        int shift = camera < cameras ? 0 : targets;
        System.arraycopy(halfSets[set], 0, sets[camera][set], shift, targets);
      }
    }
    return problem(2 * targets, sets);
  }
}
