package org.hificamsim.agents.search;

import java.util.SplittableRandom;

/** Random coverage problems for tests; as bit masks of up to 64 targets, but for {@link #wide}. */
final class Problems {
  private Problems() {}

  /** Sets by camera: up to {@code most} for each, every target in each with that probability. */
  static long[][] random(
      SplittableRandom random, int cameras, int most, int targets, double density) {
    long[][] sets = new long[cameras][];
    for (int camera = 0; camera < cameras; camera++) {
      sets[camera] = new long[1 + random.nextInt(most)];
      for (int set = 0; set < sets[camera].length; set++) {
        for (int target = 0; target < targets; target++) {
          sets[camera][set] |= random.nextDouble() < density ? 1L << target : 0;
        }
      }
    }
    return sets;
  }

  static CoverageProblem problem(int targets, long[][] sets) {
    CoverageProblem problem = new CoverageProblem(sets.length, 100, targets);
    fill(problem, targets, sets);
    return problem;
  }

  static void fill(CoverageProblem problem, int targets, long[][] sets) {
    problem.clear(targets);
    for (long[] camera : sets) {
      problem.addCamera();
      for (int set = 0; set < camera.length; set++) {
        problem.addSet(camera, set);
      }
    }
  }

  /** The same for any number of targets. */
  static CoverageProblem wide(
      SplittableRandom random, int cameras, int most, int targets, double density) {
    CoverageProblem problem = new CoverageProblem(cameras, cameras * most, targets);
    problem.clear(targets);
    for (int camera = 0; camera < cameras; camera++) {
      problem.addCamera();
      int sets = 1 + random.nextInt(most);
      for (int set = 0; set < sets; set++) {
        long[] mask = new long[problem.words()];
        for (int target = 0; target < targets; target++) {
          mask[target / 64] |= random.nextDouble() < density ? 1L << target : 0;
        }
        problem.addSet(mask, 0);
      }
    }
    return problem;
  }

  /** Two halves of so many cameras and targets each, without a target in common. */
  static CoverageProblem apart(SplittableRandom random, int cameras, int most, int targets) {
    CoverageProblem half = wide(random, cameras, most, targets, 0.4);
    CoverageProblem problem = new CoverageProblem(2 * cameras, 2 * half.sets(), 2 * targets);
    problem.clear(2 * targets);
    for (int camera = 0; camera < 2 * cameras; camera++) {
      problem.addCamera();
      int shift = camera < cameras ? 0 : targets;
      int of = camera % cameras;
      for (int set = half.firstSet(of); set < half.endSet(of); set++) {
        problem.addSet(shifted(half, set, shift, problem.words()), 0);
      }
    }
    return problem;
  }

  private static long[] shifted(CoverageProblem problem, int set, int by, int words) {
    long[] mask = new long[words];
    for (int target = 0; target < problem.targets(); target++) {
      int to = target + by;
      mask[to / 64] |= problem.contains(set, target) ? 1L << to : 0;
    }
    return mask;
  }
}
