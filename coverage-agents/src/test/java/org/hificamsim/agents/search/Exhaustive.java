package org.hificamsim.agents.search;

import java.util.Arrays;
import java.util.function.IntUnaryOperator;
import java.util.stream.IntStream;
import org.hificamsim.core.metrics.Objective;

/**
 * The reference for any objective that tries every configuration, in the order of preference:
 * {@code sets} by camera, set and target.
 */
record Exhaustive(double score, int[] configuration) {
  static Exhaustive solve(Objective objective, int targets, boolean[][][] sets) {
    int[] tried = new int[sets.length];
    int[] best = tried.clone();
    int[] most = k(objective, targets, sets, best);
    do {
      int[] k = k(objective, targets, sets, tried);
      if (isBetter(objective, k, most)) {
        best = tried.clone();
        most = k;
      }
    } while (next(tried, camera -> sets[camera].length));
    return new Exhaustive(objective.score(most, 0, most.length), best);
  }

  /** Counts up with the last camera fastest, so that the first best is the most preferred. */
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
    int[] k = k(objective, targets, sets, configuration);
    return objective.score(k, 0, k.length);
  }

  private static boolean isBetter(Objective objective, int[] k, int[] than) {
    if (!(objective instanceof Objective.Lexicographic)) {
      return objective.score(k, 0, k.length) > objective.score(than, 0, k.length);
    }
    int[] sorted = k.clone();
    int[] other = than.clone();
    Arrays.sort(sorted);
    Arrays.sort(other);
    return Arrays.compare(sorted, other) > 0;
  }

  /** Of the targets that count, by target. */
  private static int[] k(
      Objective objective, int targets, boolean[][][] sets, int[] configuration) {
    return IntStream.range(0, targets)
        .filter(target -> !objective.ofCoverableAlone() || isCoverable(sets, target))
        .map(target -> k(sets, configuration, target))
        .toArray();
  }

  private static int k(boolean[][][] sets, int[] configuration, int target) {
    return (int)
        IntStream.range(0, sets.length)
            .filter(camera -> sets[camera][configuration[camera]][target])
            .count();
  }

  private static boolean isCoverable(boolean[][][] sets, int target) {
    return Arrays.stream(sets).flatMap(Arrays::stream).anyMatch(set -> set[target]);
  }
}
