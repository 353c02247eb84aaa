package org.hificamsim.placement.cover;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Finds the candidates that a plan may need. A candidate is dominated, and left out, if it covers
 * nothing, or if enough others cover all its points at no higher price: as many as the greatest
 * number of times that any point counts.
 */
final class Dominance {
  private final CoverInstance instance;
  private final int dominatorsNeeded;
  private final List<List<Integer>> keptByPoint = new ArrayList<>();

  private Dominance(CoverInstance instance) {
    this.instance = instance;
    this.dominatorsNeeded = Math.max(1, Arrays.stream(instance.needs()).max().orElse(1));
    for (int point = 0; point < instance.points(); point++) {
      keptByPoint.add(new ArrayList<>());
    }
  }

  /** Returns the candidates that are not dominated, rising. */
  static int[] undominated(CoverInstance instance) {
    return new Dominance(instance).undominated();
  }

  private int[] undominated() {
    List<Integer> largestFirst =
        IntStream.range(0, instance.candidates())
            .boxed()
            .filter(candidate -> instance.covered()[candidate].length > 0)
            .sorted(
                Comparator.<Integer>comparingInt(candidate -> -instance.covered()[candidate].length)
                    .thenComparingDouble(candidate -> instance.prices()[candidate]))
            .toList();
    IntStream.Builder kept = IntStream.builder();
    for (int candidate : largestFirst) {
      if (!isDominated(candidate)) {
        kept.add(candidate);
        for (int point : instance.covered()[candidate]) {
          keptByPoint.get(point).add(candidate);
        }
      }
    }
    return kept.build().sorted().toArray();
  }

  /** Compares with the candidates kept so far, which cover at least as many points. */
  private boolean isDominated(int candidate) {
    int[] points = instance.covered()[candidate];
    List<Integer> fewestKept = keptByPoint.get(points[0]);
    for (int point : points) {
      List<Integer> kept = keptByPoint.get(point);
      fewestKept = kept.size() < fewestKept.size() ? kept : fewestKept;
    }
    int dominators = 0;
    for (int i = 0; i < fewestKept.size() && dominators < dominatorsNeeded; i++) {
      int other = fewestKept.get(i);
      boolean asCheap = instance.prices()[other] <= instance.prices()[candidate];
      dominators += asCheap && includes(instance.covered()[other], points) ? 1 : 0;
    }
    return dominators >= dominatorsNeeded;
  }

  /** Compares the ends first, where most lists that are not included differ. */
  private static boolean includes(int[] points, int[] part) {
    if (part[0] < points[0] || part[part.length - 1] > points[points.length - 1]) {
      return false;
    }
    int from = 0;
    for (int point : part) {
      from = Arrays.binarySearch(points, from, points.length, point);
      if (from < 0) {
        return false;
      }
    }
    return true;
  }
}
