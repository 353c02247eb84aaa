package org.hificamsim.agents.search;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.hificamsim.core.metrics.Objective;

/**
 * The reference for any objective that tries every configuration, in the order of preference:
 * {@code sets} by camera, set and target.
 */
record BestByObjective(double score, int[] choice) {
  static BestByObjective of(Objective objective, int targets, boolean[][][] sets) {
    int[] choice = new int[sets.length];
    int[] best = choice.clone();
    do {
      if (isBetter(
          objective, k(objective, targets, sets, choice), k(objective, targets, sets, best))) {
        best = choice.clone();
      }
    } while (Exhaustive.next(choice, camera -> sets[camera].length));
    return new BestByObjective(score(objective, targets, sets, best), best);
  }

  static double score(Objective objective, int targets, boolean[][][] sets, int[] choice) {
    int[] k = k(objective, targets, sets, choice);
    return objective.score(k, 0, k.length);
  }

  private static boolean isBetter(Objective objective, int[] k, int[] than) {
    if (!(objective instanceof Objective.Lexicographic)) {
      return objective.score(k, 0, k.length) > objective.score(than, 0, k.length);
    }
    Arrays.sort(k);
    Arrays.sort(than);
    return Arrays.compare(k, than) > 0;
  }

  /** Of the targets that count, by target. */
  private static int[] k(Objective objective, int targets, boolean[][][] sets, int[] choice) {
    return IntStream.range(0, targets)
        .filter(target -> !objective.ofCoverableAlone() || isCoverable(sets, target))
        .map(target -> k(sets, choice, target))
        .toArray();
  }

  private static int k(boolean[][][] sets, int[] choice, int target) {
    return (int)
        IntStream.range(0, sets.length)
            .filter(camera -> sets[camera][choice[camera]][target])
            .count();
  }

  private static boolean isCoverable(boolean[][][] sets, int target) {
    return Arrays.stream(sets).flatMap(Arrays::stream).anyMatch(set -> set[target]);
  }
}
