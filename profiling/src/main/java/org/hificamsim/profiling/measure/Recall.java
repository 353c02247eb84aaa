package org.hificamsim.profiling.measure;

import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * Recall against the object's height in pixels: of the photos whose object is about as high, the
 * share in which a detector has found it. Photos are sorted by height and cut into ten groups of
 * one size; those of one height stay together.
 */
final class Recall {
  private static final int GROUPS = 10;

  private Recall() {}

  /**
   * The rows with a column more.
   *
   * @param heights of the objects, pixels, in the order of the rows
   */
  static List<Measurement> with(List<Measurement> rows, int[] heights, String detector) {
    int[] sorted = IntStream.of(heights).sorted().toArray();
    int[] highest = // of each group
        IntStream.rangeClosed(1, GROUPS)
            .map(group -> group * sorted.length / GROUPS)
            .filter(end -> end > 0)
            .map(end -> sorted[end - 1])
            .toArray();
    int[] groups =
        IntStream.of(heights)
            .map(h -> IntStream.of(highest).filter(most -> most >= h).findFirst().orElseThrow())
            .toArray();
    Map<Integer, Double> recall =
        IntStream.range(0, groups.length)
            .boxed()
            .collect(
                Collectors.groupingBy(
                    i -> groups[i],
                    Collectors.averagingInt(i -> rows.get(i).confidence(detector) > 0 ? 1 : 0)));
    return IntStream.range(0, groups.length)
        .mapToObj(i -> rows.get(i).with(detector + "-recall", recall.get(groups[i])))
        .toList();
  }
}
