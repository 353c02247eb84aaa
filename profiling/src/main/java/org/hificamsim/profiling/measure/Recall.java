package org.hificamsim.profiling.measure;

import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * Computes recall by the object's height in pixels: the share of the photos in which a detector has
 * found an object of about this height. Photos are sorted by height and divided into ten groups of
 * equal size, but photos of equal height stay in one group.
 */
final class Recall {
  private static final int GROUPS = 10;

  private Recall() {}

  /**
   * Returns the rows with an additional column of recall.
   *
   * @param heights the heights of the objects in pixels, in the order of the rows
   */
  static List<Measurement> with(List<Measurement> rows, int[] heights, String detector) {
    int[] sorted = IntStream.of(heights).sorted().toArray();
    int[] groupMaxima =
        IntStream.rangeClosed(1, GROUPS)
            .map(group -> group * sorted.length / GROUPS)
            .filter(end -> end > 0)
            .map(end -> sorted[end - 1])
            .toArray();
    int[] groups =
        IntStream.of(heights)
            .map(
                height ->
                    IntStream.of(groupMaxima)
                        .filter(maximum -> maximum >= height)
                        .findFirst()
                        .orElseThrow())
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
