package org.hificamsim.solver.configuration;

import java.util.Arrays;
import java.util.function.IntUnaryOperator;
import java.util.stream.IntStream;
import org.hificamsim.core.metrics.Objective;

/**
 * The best configuration of a problem, found by trying every configuration in the order of
 * preference. In all methods, {@code sets} says by camera, set and target whether the set holds the
 * target.
 */
record Exhaustive(double score, int[] configuration) {
  static Exhaustive solve(Objective objective, int targets, boolean[][][] sets) {
    int[] tried = new int[sets.length];
    int[] best = tried.clone();
    int[] bestCoverage = coverage(objective, targets, sets, best);
    do {
      int[] coverage = coverage(objective, targets, sets, tried);
      if (isBetter(objective, coverage, bestCoverage)) {
        best = tried.clone();
        bestCoverage = coverage;
      }
    } while (next(tried, camera -> sets[camera].length));
    return new Exhaustive(objective.score(bestCoverage, 0, bestCoverage.length), best);
  }

  /** Goes on to the next configuration, in the order of preference; returns false at the end. */
  static boolean next(int[] configuration, IntUnaryOperator count) {
    for (int camera = configuration.length - 1; camera >= 0; camera--) {
      if (++configuration[camera] < count.applyAsInt(camera)) {
        return true;
      }
      configuration[camera] = 0;
    }
    return false;
  }

  static double score(Objective objective, int targets, boolean[][][] sets, int[] configuration) {
    int[] coverage = coverage(objective, targets, sets, configuration);
    return objective.score(coverage, 0, coverage.length);
  }

  private static boolean isBetter(Objective objective, int[] coverage, int[] best) {
    if (!(objective instanceof Objective.Lexicographic)) {
      return objective.score(coverage, 0, coverage.length) > objective.score(best, 0, best.length);
    }
    int[] sorted = coverage.clone();
    int[] sortedBest = best.clone();
    Arrays.sort(sorted);
    Arrays.sort(sortedBest);
    return Arrays.compare(sorted, sortedBest) > 0;
  }

  /** The number of cameras that cover each target that counts. */
  private static int[] coverage(
      Objective objective, int targets, boolean[][][] sets, int[] configuration) {
    return IntStream.range(0, targets)
        .filter(target -> !objective.countsCoverableOnly() || isCoverable(sets, target))
        .map(target -> coverage(sets, configuration, target))
        .toArray();
  }

  private static int coverage(boolean[][][] sets, int[] configuration, int target) {
    return (int)
        IntStream.range(0, sets.length)
            .filter(camera -> sets[camera][configuration[camera]][target])
            .count();
  }

  private static boolean isCoverable(boolean[][][] sets, int target) {
    return Arrays.stream(sets).flatMap(Arrays::stream).anyMatch(set -> set[target]);
  }
}
