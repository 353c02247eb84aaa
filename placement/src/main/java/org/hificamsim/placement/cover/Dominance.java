package org.hificamsim.placement.cover;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Leaves out candidates that no plan needs: those that see nothing, and those of whose samples as
 * many others, at no higher price, see all as any sample counts times.
 */
final class Dominance {
  private final CoverInstance instance;
  private final int most;
  private final List<List<Integer>> keptBySample = new ArrayList<>();

  private Dominance(CoverInstance instance) {
    this.instance = instance;
    this.most = Math.max(1, Arrays.stream(instance.needs()).max().orElse(1));
    IntStream.range(0, instance.samples()).forEach(any -> keptBySample.add(new ArrayList<>()));
  }

  /** The candidates that are left, rising. */
  static int[] left(CoverInstance instance) {
    return new Dominance(instance).left();
  }

  private int[] left() {
    List<Integer> kept = new ArrayList<>();
    IntStream.range(0, instance.candidates())
        .boxed()
        .filter(one -> instance.columns()[one].length > 0)
        .sorted(
            Comparator.<Integer>comparingInt(one -> -instance.columns()[one].length)
                .thenComparingDouble(one -> instance.prices()[one]))
        .forEach(
            one -> {
              if (!isDominated(one)) {
                kept.add(one);
                for (int sample : instance.columns()[one]) {
                  keptBySample.get(sample).add(one);
                }
              }
            });
    return kept.stream().mapToInt(Integer::intValue).sorted().toArray();
  }

  private boolean isDominated(int one) {
    int[] column = instance.columns()[one];
    List<Integer> fewest = keptBySample.get(column[0]);
    for (int sample : column) {
      List<Integer> here = keptBySample.get(sample);
      fewest = here.size() < fewest.size() ? here : fewest;
    }
    int dominating = 0;
    for (int i = 0; i < fewest.size() && dominating < most; i++) {
      int other = fewest.get(i);
      boolean asCheap = instance.prices()[other] <= instance.prices()[one];
      dominating += asCheap && includes(instance.columns()[other], column) ? 1 : 0;
    }
    return dominating >= most;
  }

  /** Most that do not include differ at the ends. */
  private static boolean includes(int[] column, int[] part) {
    if (part[0] < column[0] || part[part.length - 1] > column[column.length - 1]) {
      return false;
    }
    int from = 0;
    for (int sample : part) {
      from = Arrays.binarySearch(column, from, column.length, sample);
      if (from < 0) {
        return false;
      }
    }
    return true;
  }
}
